#pragma once

#include "lab/match/beam_renderer.h"
#include "lab/match/match.h"

/// A match, and what it compared.
struct MatchedWithPictures {
    Matched matched;
    MatchPictures pictures;
};

/// Finds the amounts of a look that a signal drives: the width of its beam from the profile of a
/// line, and its bloom from an isolated dot. The corners and the gamma of the camera are known. Its
/// blur is not: a Gaussian widens a line just as the beam does, so the intervals cover the usual
/// blurs. When it is cancelled after the first fit, it returns what it has found. Fails if the
/// photo shows neither a straight line nor a dot, or all of them overexposed.
Result<MatchedWithPictures> match_beam(BeamRenderer& renderer, const Picture& photo,
                                       const MatchRequest& request, JobProgress& work);
