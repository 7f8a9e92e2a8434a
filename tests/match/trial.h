#pragma once

#include "lab/match/match.h"
#include "match/synthetic_camera.h"

#include <array>
#include <filesystem>
#include <map>
#include <string>

/// A photo of a known screen by a known camera, and what the user would give `afterglow match`.
struct Trial {
    int seed = 1;
    int mask = 1;               // item of the type: 1 aperture grille, 2 slot mask, 3 dot triads
    double corner_error = 0.0;  // px of the photo: standard deviation in x and in y
    bool is_small = false;      // fewer pixels, no bloom, and a known curvature
    double mask_size = 0.0;     // px of the fitted picture; 0: by the seed
    std::string source = "pattern:harbour";  // that the user names
};

/// What a trial found.
struct TrialResult {
    std::map<std::string, double> truth;  // by parameter
    Matched matched;
    double residual_of_truth = 0.0;   // of the true values, with the best camera
    double explained_by_truth = 0.0;  // share, likewise
    double seconds = 0.0;
};

/// The corners of the screen in the photo.
std::array<glm::dvec2, 4> true_corners(const Trial& trial);
/// Takes the photo and reads it from a JPEG in this folder.
Result<Picture> take_photo(const Trial& trial, const std::filesystem::path& folder);
/// Fails like match_photo().
Result<TrialResult> run_trial(const Trial& trial, const std::filesystem::path& folder);
