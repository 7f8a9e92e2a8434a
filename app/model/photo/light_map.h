#pragma once

#include "model/look/picture.h"

#include <glm/glm.hpp>

#include <vector>

/// Linear light of one colour. Positions are px from the top left corner; a pixel's centre is at
/// +0.5.
struct LightMap {
    Extent extent;
    std::vector<float> light;  // rows from the top

    /// Between pixels, linearly. Outside, the nearest pixel counts.
    float at(glm::dvec2 position) const;
};

/// The linear light of red, green or blue, whichever is strongest in the picture. `picture`:
/// floats, 3 or 4 channels. Display values are sRGB.
LightMap light_map(const Picture& picture);
/// The same of a photo, whose values are light ^ (1 / gamma).
LightMap light_of_photo(const Picture& photo, double gamma);

/// Blurred by a Gaussian with this standard deviation, px.
LightMap blurred(const LightMap& map, double sigma);
