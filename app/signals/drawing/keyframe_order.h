#pragma once

#include <cstddef>
#include <vector>

/// Playback order of keyframes.
enum class KeyframePlay {
    loop,            // the first follows the last
    back_and_forth,  // to the last and back
    once,            // stops at the last
    still            // a single keyframe
};

/// The timing of keyframes: each is held, then morphs into the next.
struct KeyframeOrder {
    std::vector<std::size_t> keyframes;  // in playback order; never empty
    bool loops = false;                  // the first follows the last
    double hold_seconds = 0.0;
    double morph_seconds = 0.0;
    bool is_eased = true;  // smoothstep, 3 x^2 - 2 x^3

    /// The step from keyframes[step] to the next, and its progress, 0..1.
    struct Moment {
        std::size_t step = 0;
        double share = 0.0;
    };
    Moment at(double seconds) const;
    std::size_t steps() const;
    std::size_t begin_of(std::size_t step) const { return keyframes[step]; }
    std::size_t end_of(std::size_t step) const { return keyframes[(step + 1) % keyframes.size()]; }
};

/// The order of `count` keyframes. `still_at` is the keyframe for KeyframePlay::still, from 0.
KeyframeOrder order_of(KeyframePlay play, std::size_t count, std::size_t still_at);
