#include "lab/rendering/frame_limit.h"

#include <algorithm>

double longest_frame(const FrameCost& cost) {
    constexpr double fewest = 1.0 / 60.0;
    constexpr double maximum = 0.25;
    constexpr double always_granted = 2.0 / 60.0;
    if (cost.beam_seconds <= 0.0 || cost.span_seconds <= 0.0)
        return maximum;
    const double rest = std::max(0.0, cost.wall_seconds - cost.beam_seconds);
    const double granted = std::max(always_granted, 0.5 * rest);
    return std::clamp(granted * cost.span_seconds / cost.beam_seconds, fewest, maximum);
}
