#pragma once

#include "lab/library/library.h"
#include "lab/match/found_numbers.h"
#include "lab/match/matched_parameters.h"
#include "lab/match/video_light.h"
#include "lab/offline/prepared_look.h"
#include "model/photo/time_constants.h"

#include <string>
#include <vector>

/// A measured tube and its probability among those of the look, which are equally likely before.
struct TubeProbability {
    std::string label;
    double probability = 0.0;
};

/// What a video of fading light says about a look.
struct DecayMatch {
    glm::dvec2 at{0.0};  // the place in the video, px
    double fps = 0.0;
    int frames = 0;       // after the light went off
    int lit_frames = 0;   // before that
    double misfit = 0.0;  // mean square of the differences in standard deviations; 1: as expected
    std::string tube_parameter;          // "": the look has no list of tubes
    std::string tube;                    // the label of the chosen item
    std::vector<TubeProbability> tubes;  // most likely first
    std::vector<FoundNumber> numbers;
    std::vector<TimeConstant> constants;  // of the video, without the look
    Values values;                        // that were found, by parameter
};

/// Finds the parameters with `@photo tube` and `@photo decay`, and those that the user wants. A
/// tube is compared by its likelihood at the rate of the video. An item for which a decay is to be
/// found is chosen only if it explains the video much better than all measured tubes. Fails for
/// looks without such parameters, and as read_light() and recorded_decay().
Result<DecayMatch> match_decay(PreparedLook prepared, const VideoOfDecay& video,
                               const MatchChoice& choice, JobProgress& work);

/// What a large misfit means, for the user. "": the misfit is small.
std::string misfit_text(const DecayMatch& match);

/// The same for files, as the command line names them.
struct DecayFile {
    Document document;  // with the values that were found
    DecayMatch match;
    Diagnostics warnings = {};
};
Result<DecayFile> match_decay_file(const RenderRequest& render, const VideoOfDecay& video,
                                   const MatchChoice& choice, const Library& library,
                                   JobProgress& work);
