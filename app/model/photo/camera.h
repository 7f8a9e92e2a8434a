#pragma once

#include "base/diagnostic.h"
#include "model/look/extent.h"

#include <glm/glm.hpp>

#include <array>

/// The corners of a screen in a photo: px from the photo's top left corner, clockwise from the
/// screen's top left.
using Corners = std::array<glm::dvec2, 4>;

/// The corners of the whole photo.
Corners corners_of(Extent photo);

/// Fails for corners that are outside the photo, crossed, mirrored, or too close to each other.
Result<void> check_corners(const Corners& corners, Extent photo);

/// How a camera shows a flat screen: a photo's value is
/// (vignette * colour * blurred light) ^ (1 / gamma), seen in perspective through a lens.
struct Camera {
    Corners corners = {};     // of the screen, as seen through the lens
    double lens = 0.0;        // radial distortion: r is seen at r (1 + lens r^2)
    double blur = 1.0;        // of the lens: standard deviation, px of the photo
    double sharpening = 0.0;  // added share of what a blur of 1 px removes; interpolating a
                              // mosaic of colours also sharpens
    double mosaic = 0.0;  // effects of interpolating a mosaic of colours: 0 none, 1 those of the
                          // filters of Malvar, He and Cutler 2004
    double chroma_blur = 0.5;  // of the colour differences: standard deviation, px of the photo
    double vignette = 0.0;     // light lost at the photo's corners: 1 - vignette r^2
    double gamma = 2.2;
    glm::dmat3 colour{1.0};  // linear light of the screen to linear light of the camera

    bool operator==(const Camera&) const = default;
};

/// Where a camera shows the places of a screen. r is measured from the photo's centre, in units of
/// half its diagonal.
class ScreenMap {
public:
    ScreenMap(const Camera& camera, Extent photo);

    /// The position in the photo, px, of a place on the screen: 0..1 from its top left corner.
    glm::dvec2 photo_at(glm::dvec2 place) const;
    /// The change of the position in the photo by one px across (first column) and down of a
    /// picture with this size, at a place on the screen.
    glm::dmat2 slope_at(glm::dvec2 place, Extent picture) const;
    /// r^2 of a position in the photo.
    double squared_radius(glm::dvec2 position) const;

private:
    glm::dvec2 m_centre;
    double m_unit;  // px
    double m_lens;
    glm::dmat3 m_perspective;  // of a place on the screen, to px without the lens
};
