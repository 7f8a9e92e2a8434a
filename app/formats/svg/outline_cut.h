#pragma once

#include "base/diagnostic.h"
#include "signals/drawing/scene.h"

#include <cstddef>
#include <vector>

/// A clip region: rings of corners with one of SVG's two fill rules.
struct ClipRegion {
    std::vector<ScenePath> rings;
    bool is_even_odd = false;
};

/// The parts of a line inside all regions. A line within `tolerance` of an edge is inside. `tests`
/// is decremented for each tested edge; at 0 testing stops.
std::vector<ScenePath> clipped(const ScenePath& path, const std::vector<const ClipRegion*>& regions,
                               double tolerance, std::size_t& tests);

/// The dashes of a line (SVG 1.1, 11.4): alternating lengths of dashes and gaps, starting at
/// `offset`. Returns the line itself for invalid lengths or more than `maximum` dashes.
std::vector<ScenePath> dashed(const ScenePath& path, std::vector<double> lengths, double offset,
                              std::size_t maximum);
