#include "lab/window/pane_sizes.h"

#include <algorithm>

const std::array<PaneSide, 5>& pane_sides() {
    static const std::array<PaneSide, 5> sides{
        {{"Widen left pane", "Narrow left pane", &PaneSizes::left, {170.0, 520.0}},
         {"Widen right pane", "Narrow right pane", &PaneSizes::right, {270.0, 700.0}},
         {"Enlarge pass strip", "Shrink pass strip", &PaneSizes::strip, {84.0, 260.0}},
         {"Enlarge bottom pane", "Shrink bottom pane", &PaneSizes::bottom, {80.0, 500.0}},
         {"Enlarge inspector", "Shrink inspector", &PaneSizes::inspector, {160.0, 900.0}}}};
    return sides;
}

void resize_pane(PaneSizes& panes, float PaneSizes::*size, float by) {
    const auto side = std::ranges::find(pane_sides(), size, &PaneSide::size);
    panes.*size = std::clamp(panes.*size + by, static_cast<float>(side->limit.low),
                             static_cast<float>(side->limit.high));
}
