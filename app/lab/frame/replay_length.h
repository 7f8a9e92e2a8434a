#pragma once

#include "lab/frame/workspace.h"

#include <cstddef>

/// The latest frames that a replay draws.
struct ReplayLength {
    std::size_t frames = 1;
    bool is_complete = true;  // false: a longer replay follows when the drag ends
};

/// After how many frames the open look has settled, at least 1.
std::size_t settling_frames(const Workspace& work);
/// The length of the requested replay: until the look has settled, or all frames of the past.
/// During a drag only as many frames are replayed as take 0.2 s. If no frame depends on earlier
/// ones, one frame is all.
ReplayLength replay_length(const Workspace& work);
