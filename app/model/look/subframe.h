#pragma once

#include "model/look/look.h"

#include <cstdint>

constexpr int max_subframes = 16;

/// One of the frames that show the same source picture. Without sub-frames there is only one.
struct Subframe {
    int index = 0;  // from 0
    int count = 1;  // per source picture

    bool is_first() const { return index == 0; }
    bool operator==(const Subframe&) const = default;
};

/// The sub-frame of a frame, which is counted from 1.
Subframe subframe_of(std::int64_t frame, int count);

/// The source pictures up to a frame, counted from 1.
std::int64_t source_frame_of(std::int64_t frame, int count);

/// The sub-frames that the look asks for, 1 to max_subframes.
int subframes_of(const Look& look, const Values& values);
