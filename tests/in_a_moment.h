#pragma once

#include "base/elapsed.h"

#include <string>
#include <string_view>

/// Whether some work ends within seconds, also on a slow machine. Given a text of megabytes, what
/// takes a time that grows with the square of it takes minutes.
template <class Work>
bool is_done_in_a_moment(Work work) {
    constexpr double moment_seconds = 20.0;
    const auto start = std::chrono::steady_clock::now();
    work();
    return seconds_since(start) < moment_seconds;
}

/// A piece of text so many times.
inline std::string times(std::size_t count, std::string_view piece) {
    std::string all;
    all.reserve(count * piece.size());
    for (std::size_t i = 0; i < count; ++i)
        all += piece;
    return all;
}
