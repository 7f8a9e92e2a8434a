#include "model/look/subframe.h"

#include <algorithm>

Subframe subframe_of(std::int64_t frame, int count) {
    return {static_cast<int>(std::max<std::int64_t>(frame - 1, 0) % count), count};
}

std::int64_t source_frame_of(std::int64_t frame, int count) {
    return (std::max<std::int64_t>(frame, 1) - 1) / count + 1;
}

int subframes_of(const Look& look, const Values& values) {
    return static_cast<int>(
        std::clamp(count_of(look.subframes, look, values), 1.0, double{max_subframes}));
}
