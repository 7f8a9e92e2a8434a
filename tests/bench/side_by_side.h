#pragma once

#include "gpu/draw.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

namespace bench {

/// CPU time of the whole process, all threads of the driver included.
inline double busy_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double median(std::vector<double> numbers) {
    std::ranges::sort(numbers);
    return numbers[numbers.size() / 2];
}

/// Of so many frames, each ending in glFinish.
template <class Draw>
double seconds_of(int frames, Draw draw) {
    const double start = busy_seconds();
    for (int i = 0; i < frames; ++i) {
        draw();
        gpu::finish();
    }
    return busy_seconds() - start;
}

/// What a frame of ours costs beside a yardstick's: medians over rounds.
struct Cost {
    double plain_milliseconds = 0.0;
    double our_milliseconds = 0.0;
    double ratio = 0.0;   // ours to plain
    double more = 0.0;    // ms, ours over plain
    double apart = 0.0;   // ms, the plain frames before ours from the same behind
    double itself = 0.0;  // the plain frames before ours to the same behind
    /// A machine on which the yardstick does not equal itself measures nothing.
    bool counts() const { return std::abs(itself - 1.0) <= 0.015; }
};

/// In each round the yardstick is drawn before and behind ours.
template <class Plain, class Ours>
Cost side_by_side(int rounds, int frames, Plain plain, Ours ours) {
    constexpr int warm_up = 5;
    seconds_of(warm_up, plain);
    seconds_of(warm_up, ours);
    std::vector<double> ratios;
    std::vector<double> more;
    std::vector<double> itself;
    std::vector<double> apart;
    std::vector<double> plain_milliseconds;
    std::vector<double> our_milliseconds;
    for (int i = 0; i < rounds; ++i) {
        const double before = seconds_of(frames, plain);
        const double between = seconds_of(frames, ours);
        const double behind = seconds_of(frames, plain);
        ratios.push_back(2.0 * between / (before + behind));
        more.push_back(1e3 * (between - 0.5 * (before + behind)) / frames);
        apart.push_back(1e3 * (before - behind) / frames);
        itself.push_back(before / behind);
        plain_milliseconds.push_back(1e3 * before / frames);
        our_milliseconds.push_back(1e3 * between / frames);
    }
    return {median(plain_milliseconds),
            median(our_milliseconds),
            median(ratios),
            median(more),
            median(apart),
            median(itself)};
}

}  // namespace bench
