#pragma once

#include "model/look/picture.h"

#include <glm/glm.hpp>

#include <vector>

/// A photo, for reading at any position. Positions are px from the top left
/// corner; a pixel's centre is at +0.5. Outside, the nearest pixel counts.
class Photo {
public:
    /// `picture`: floats, 3 or 4 channels, display values.
    explicit Photo(const Picture& picture);

    Extent extent() const { return m_extent; }
    /// The square of the photo's value, which is nearly linear light, by cubic interpolation
    /// (Catmull-Rom) of 4 x 4 pixels.
    glm::vec3 at(glm::dvec2 position) const;
    /// The mean light of a parallelogram around a position, from count x count samples. The columns
    /// of `sides` are its sides, px. Light is value ^ mean_gamma.
    glm::vec3 mean_light_at(glm::dvec2 position, const glm::dmat2& sides, int count) const;

    static constexpr double mean_gamma = 2.2;

private:
    // Half the size of the level before, light.
    struct Level {
        Extent extent;
        std::vector<glm::vec3> light;
    };
    const glm::vec3& pixel(int x, int y) const;
    static glm::vec3 between_texels(const Level& level, glm::dvec2 texel);

    Extent m_extent;
    std::vector<glm::vec3> m_pixels;
    std::vector<Level> m_levels;
};
