#pragma once

#include "graph/light_cells.h"
#include "graph/meter.h"
#include "graph/viewer.h"
#include "model/plan.h"

#include <array>
#include <compare>
#include <cstddef>
#include <set>

/// Looks once, at a small texture, at each kind of picture that a look's passes draw, in the ways
/// that a window does: large and small, its numbers, its flashes. A driver that keeps its code in
/// files then has that for the context which looks at the real ones, where nobody waits for it.
/// Belongs to the context that it is made in.
class FirstViews {
public:
    static Result<FirstViews> make();

    /// At what was not met before; so many kinds that was.
    std::size_t look_at(const Look& look, const Plan& plan);

private:
    /// What drivers tell apart.
    struct Kind {
        Format format;
        Encoding encoding;
        bool is_mipmapped;
        std::array<bool, 2> has_power_of_two;  // across, up
        bool has_alpha;

        auto operator<=>(const Kind&) const = default;
    };
    FirstViews(Viewer viewer, Meter meter, LightCells cells);
    void look_at(const Kind& kind);

    Viewer m_viewer;
    Meter m_meter;
    LightCells m_cells;
    std::set<Kind> m_met;
};
