#pragma once

#include "lab/match/found_numbers.h"
#include "lab/match/match_pictures.h"
#include "lab/match/matched_parameters.h"
#include "lab/match/photo_fit.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// The result of a match.
struct Matched {
    MatchState state;
    std::vector<FoundNumber> numbers;
    double residual = 0.0;    // root mean square of photo values, 0..1
    int pictures = 0;         // that were drawn
    bool is_complete = true;  // false: stopped, so the numbers have no intervals
    double explained = 1.0;   // share of the variance of light in the photo, 0..1
};

/// What the share means, for the user.
std::string explained_text(const Matched& matched);

/// What a match has found so far, for display while it works.
struct MatchProgress {
    std::string stage;  // "Curvature"
    MatchState state;
    double residual = 0.0;
    MatchPictures pictures = {};  // empty unless requested
};

struct MatchRequest {
    MatchedParameters parameters;
    MatchState start;               // the corners are the user's
    double corner_deviation = 1.0;  // px of the photo
    std::function<void(const MatchProgress&)> on_progress = {};
    bool draws_pictures = false;                                 // for each progress
    std::function<void(const Corners&)> on_better_corners = {};  // before wrong ones are refused
    std::filesystem::path photo = {};                            // for messages
};

/// Finds the parameters in stages: shape and camera in the mean light of places, periods by their
/// spectra, the type by comparison, and all numbers together. When it is cancelled after the first
/// stage, it returns what it has found. Fails with the reason if the photo does not show the look's
/// picture.
Result<Matched> match_photo(PhotoFit& fit, const MatchRequest& request);
