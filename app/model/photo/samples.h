#pragma once

#include "model/photo/camera.h"
#include "model/photo/photo.h"
#include "model/photo/sample_layout.h"

#include <glm/glm.hpp>

#include <vector>

/// The linear light of a look's picture at the samples: tiles with their margins, row by row, and
/// the mean of each cell.
struct ScreenLight {
    std::vector<glm::vec3> tiles;
    std::vector<glm::vec3> cells;
};

/// The same after the blur of a camera's lens. Tiles keep a margin for the blur of colours.
struct SoftLight {
    std::vector<glm::vec3> tiles;
    std::vector<glm::vec3> points;
};

/// Values at the samples: tiles without margins, row by row, and points. They are luma, blue
/// difference and red difference (ITU-R BT.601) of squared photo values. Squares are nearly linear
/// light, so the noise of dark places does not change their mean.
struct SampleValues {
    std::vector<glm::vec3> tiles;
    std::vector<glm::vec3> points;
};

/// Where a camera sees the samples.
struct SamplePlaces {
    SamplePlaces(const SampleLayout& layout, const Camera& camera, Extent photo);

    std::vector<glm::dvec2> tiles;   // px of the photo, without margins
    std::vector<glm::dvec2> points;  // likewise
    std::vector<float> tile_radii;   // r^2, see ScreenMap; with the margin for the blur of colours
    std::vector<float> point_radii;
    // Photo px per px of the look's picture: the columns are one px across and one px down.
    std::vector<glm::dmat2> tile_maps;  // one per tile
    std::vector<glm::dmat2> point_maps;
    ScreenMap map;
};

/// A photo at the samples.
SampleValues photographed(const Photo& photo, const SampleLayout& layout,
                          const SamplePlaces& places);

/// The light after the blur of the camera's lens and the camera's sharpening.
SoftLight blurred(const ScreenLight& light, const Camera& camera, const SampleLayout& layout,
                  const SamplePlaces& places);

/// What a camera makes of blurred light: colour, vignette, gamma and the blur of colours.
SampleValues developed(const SoftLight& light, const Camera& camera, const SampleLayout& layout,
                       const SamplePlaces& places);

/// How values change from one px of the look's picture to the next.
struct SampleSlopes {
    SampleValues across;
    SampleValues down;
};
SampleSlopes developed_slopes(const SoftLight& light, const Camera& camera,
                              const SampleLayout& layout, const SamplePlaces& places);
