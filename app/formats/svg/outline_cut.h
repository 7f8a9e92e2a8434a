#pragma once

#include "base/diagnostic.h"
#include "signals/drawing/scene.h"

#include <cstddef>
#include <vector>

/// A region that lines are cut to: rings of corners, by one of SVG's two rules.
struct ClipRegion {
    std::vector<ScenePath> rings;
    bool is_even_odd = false;
};

/// The parts of a line that lie in all regions; a line on the edge of one lies in it, by
/// `tolerance`. `tests` counts down with each edge that is looked at; at 0 nothing more is cut.
std::vector<ScenePath> clipped(const ScenePath& path, const std::vector<const ClipRegion*>& regions,
                               double tolerance, std::size_t& tests);

/// The dashes of a line (SVG 1.1, 11.4): lengths of dashes and gaps in turn, begun `offset` into
/// them. The line itself where the lengths say nothing, or where more than `most` dashes come of
/// them.
std::vector<ScenePath> dashed(const ScenePath& path, std::vector<double> lengths, double offset,
                              std::size_t most);
