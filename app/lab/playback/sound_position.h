#pragma once

#include "lab/playback/played_signal.h"

#include <optional>

/// The part of a sound that plays, in seconds of the sound. Time 0 of the clock is at its start.
struct PlayedPart {
    double start = 0.0;
    double end = 0.0;
    bool loops = false;

    bool operator==(const PlayedPart&) const = default;
    double seconds() const { return end - start; }
    /// The position in the sound at a time of the clock. Beyond the end of a part that does not
    /// loop it counts on.
    double position_at(double time) const;
    /// The first time of the clock at a position, which is limited to the part.
    double time_at(double position) const;
};

/// The part of the signal's sound that plays; nullopt: no sound. The settings `start`, `end` and
/// `loop` of the signal define it, so presets, sessions and exports have it too.
std::optional<PlayedPart> played_part(const PlayedSignal& signal);
