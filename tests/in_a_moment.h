#pragma once

#include <ctime>
#include <string>
#include <string_view>

/// Whether some work takes the processor no more than seconds. Given a text of megabytes, what
/// takes a time that grows with the square of it takes minutes.
template <class JobProgress>
bool is_done_in_a_moment(JobProgress work) {
    constexpr double moment_seconds = 20.0;
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) < moment_seconds * CLOCKS_PER_SEC;
}

/// A piece of text so many times.
inline std::string times(std::size_t count, std::string_view piece) {
    std::string all;
    all.reserve(count * piece.size());
    for (std::size_t i = 0; i < count; ++i)
        all += piece;
    return all;
}
