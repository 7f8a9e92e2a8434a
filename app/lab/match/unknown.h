#pragma once

#include "model/look/look.h"
#include "model/photo/camera.h"

#include <string>
#include <vector>

/// The values of the look and the camera that explain a photo.
struct MatchState {
    Values values;
    Camera camera;
};

/// A number of a MatchState that a fit changes.
struct Unknown {
    enum class Part {
        look,
        corner,
        lens,
        blur,
        sharpening,
        mosaic,
        chroma_blur,
        vignette,
        gamma,
        colour
    };

    Part part = Part::look;
    std::size_t index = 0;       // component of the parameter, of the corners or of the matrix
    std::string parameter = {};  // of the look
    double low = 0.0;
    double high = 1.0;
    double difference = 1e-3;     // for derivatives
    bool is_central = false;      // derivatives from both sides, for numbers that move patterns
    double trust = 1.0;           // largest change per step
    double expected = 0.0;        // with `deviation`
    double deviation = 0.0;       // of what is known before the photo; 0: nothing is known
    double interval_scale = 1.0;  // of its 90 % interval, see found_numbers()

    double of(const MatchState& state) const;
    void set(MatchState& state, double value) const;
    /// Whether it moves the samples on the photo.
    bool is_geometric() const { return part == Part::corner || part == Part::lens; }
};

/// "the camera's blur"; for parts of the camera.
std::string camera_part_name(Unknown::Part part);

/// The colour matrix with gain, vignette and gamma of a camera.
std::vector<Unknown> exposure_unknowns();
/// Blurs, sharpening and mosaic of a camera.
std::vector<Unknown> blur_unknowns();
/// Corners and lens. Corners are known within `corner_deviation` px of those of `camera`.
std::vector<Unknown> geometry_unknowns(const Camera& camera, double corner_deviation);
