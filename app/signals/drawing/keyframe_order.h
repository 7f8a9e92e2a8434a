#pragma once

#include <cstddef>
#include <vector>

/// How keyframes follow each other.
enum class KeyframePlay {
    loop,            // after the last comes the first
    back_and_forth,  // to the last and back
    once,            // to the last, which stays
    still            // one of them stays
};

/// When which keyframe is seen: each is held, and then turns into the next.
struct KeyframeOrder {
    std::vector<std::size_t> keyframes;  // in the order of their coming; never empty
    bool comes_round = false;            // after the last of them comes the first
    double hold_seconds = 0.0;
    double morph_seconds = 0.0;
    bool is_eased = true;  // begins and ends gently: 3 x^2 - 2 x^3

    /// The step from keyframes[step] to the next, and how much of its way is gone, 0..1.
    struct Moment {
        std::size_t step = 0;
        double share = 0.0;
    };
    Moment at(double seconds) const;
    std::size_t steps() const;
    std::size_t begin_of(std::size_t step) const { return keyframes[step]; }
    std::size_t end_of(std::size_t step) const { return keyframes[(step + 1) % keyframes.size()]; }
};

/// The order of `count` keyframes; `still_at` is the one that stays, from 0, where one does.
KeyframeOrder order_of(KeyframePlay play, std::size_t count, std::size_t still_at);
