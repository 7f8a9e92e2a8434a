#include "lab/playback/sound_position.h"

#include <algorithm>
#include <cmath>

double PlayedPart::position_at(double time) const {
    return start + (loops && seconds() > 0.0 ? std::fmod(std::max(time, 0.0), seconds()) : time);
}

double PlayedPart::time_at(double position) const {
    constexpr double last = 0.001;  // s; at the end itself a loop starts again
    return std::clamp(position, start, std::max(start, end - last)) - start;
}

std::optional<PlayedPart> played_part(const PlayedSignal& signal) {
    const SoundTrack track = signal.track();
    if (!track.sound)
        return std::nullopt;
    return PlayedPart{track.start_seconds, track.start_seconds + signal.sound_seconds(),
                      track.loops};
}
