#pragma once

#include "model/photo/light_map.h"

#include <vector>

/// A straight line of light, or an isolated dot.
struct BeamPlace {
    glm::dvec2 at{0.0};     // px, in the middle of the light
    glm::dvec2 along{0.0};  // unit vector of the line's direction; 0: a dot

    bool is_line() const { return along != glm::dvec2(0.0); }
};

/// The light at `values` distances from the middle of a line or dot, from 0 to the reach. One row
/// for each piece of the line, or sector around the dot.
struct BeamProfile {
    static constexpr std::size_t values = 96;
    static constexpr std::size_t pieces = 16;

    std::vector<std::vector<double>> light;

    std::vector<double> mean() const;
};

/// `reach`: px, across the line or around the dot; the pieces of a line cover as much to each side.
/// Each piece has its own middle, so a line may be slightly bent.
BeamProfile beam_profile(const LightMap& map, const BeamPlace& place, double reach);
