#include "lab/pane_sizes.h"

#include <algorithm>

const std::array<PaneSide, 5>& pane_sides() {
    static const std::array<PaneSide, 5> sides{
        {{"Left pane", "wider", "narrower", &PaneSizes::left, {170.0, 520.0}},
         {"Right pane", "wider", "narrower", &PaneSizes::right, {270.0, 700.0}},
         {"Strip of passes", "higher", "lower", &PaneSizes::strip, {84.0, 260.0}},
         {"Bottom pane", "higher", "lower", &PaneSizes::bottom, {80.0, 500.0}},
         {"Inspector", "higher", "lower", &PaneSizes::inspector, {160.0, 900.0}}}};
    return sides;
}

void resize_pane(PaneSizes& panes, float PaneSizes::*size, float by) {
    const auto side = std::ranges::find(pane_sides(), size, &PaneSide::size);
    panes.*size = std::clamp(panes.*size + by, static_cast<float>(side->limit.low),
                             static_cast<float>(side->limit.high));
}
