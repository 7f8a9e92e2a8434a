#pragma once

#include "lab/match/photo_fit.h"

/// A photo and what the camera would see of the look, side by side in the size of the look's
/// picture. Display values. The edges, which are not compared, are cut off.
struct MatchPictures {
    Picture photo;
    Picture seen;
};

/// Draws the look. Fails when cancelled.
Result<MatchPictures> match_pictures(PhotoFit& fit, const MatchState& state);
