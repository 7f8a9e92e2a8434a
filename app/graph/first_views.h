#pragma once

#include "graph/light_cells.h"
#include "graph/meter.h"
#include "graph/viewer.h"
#include "model/plan.h"

#include <array>
#include <cstddef>
#include <set>
#include <tuple>

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

        bool operator<(const Kind& other) const {
            return std::tie(format, encoding, is_mipmapped, has_power_of_two, has_alpha) <
                   std::tie(other.format, other.encoding, other.is_mipmapped,
                            other.has_power_of_two, other.has_alpha);
        }
    };
    FirstViews(Viewer viewer, Meter meter, LightCells cells);
    void look_at(const Kind& kind);

    Viewer m_viewer;
    Meter m_meter;
    LightCells m_cells;
    std::set<Kind> m_met;
};
