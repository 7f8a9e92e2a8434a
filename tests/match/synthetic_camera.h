#pragma once

#include "model/look/picture.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <filesystem>

/// A camera in front of a flat screen, and how it develops the picture.
struct SyntheticCamera {
    // Of the screen in the photo, as seen through the lens (after distortion). Photo pixels from
    // the photo's top left corner, clockwise from the screen's top left.
    std::array<glm::dvec2, 4> corners;
    // Radial distortion k1. A point at the undistorted distance r from the photo's centre is seen
    // at r (1 + k1 r^2). The unit of r is half the photo's diagonal.
    double lens = 0.0;
    double blur = 1.3;  // standard deviation of the lens's Gaussian blur, px of the photo
    // Of the sensor: the standard deviation is noise * sqrt(light), with light at least 0.02.
    double noise = 0.01;
    double vignette = 0.25;  // light lost at the photo's corners: 1 - vignette r^2
    double gain = 0.8;
    double gamma = 2.2;      // photo value = light^(1 / gamma)
    glm::dmat3 colour{1.0};  // linear light of the screen to linear light of the camera
    // RGGB mosaic, red in the top left pixel, developed with the 5x5 filters of Malvar, He and
    // Cutler 2004, "High-quality linear interpolation for demosaicing of Bayer-patterned color
    // images". At the borders the mosaic is mirrored.
    bool has_bayer = true;
    std::uint32_t seed = 1;  // of the noise
};

/// The photo of a screen. `screen`: linear light, 3 or 4 channels (alpha is ignored), any size; its
/// outermost pixel edges lie between the corners, and black surrounds it. Result: 3 channels,
/// display values clamped to 0..1, rounded to 8 bits. The sensor does not clip before that.
Picture photograph(const Picture& screen, const SyntheticCamera& camera, Extent photo);

/// Writes a photo as JPEG with 4:2:0 chroma. `quality`: 1..100. Returns whether it was written.
bool save_jpeg(const Picture& photo, const std::filesystem::path& file, int quality);
