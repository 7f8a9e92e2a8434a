#pragma once

#include "model/beam.h"

#include <array>
#include <cstdint>
#include <span>

/// What a frame of a look is drawn for: its time, its beam, the mouse.
struct Frame {
    double time = 0;                // s, at the frame's end
    double time_delta = 0;          // s
    std::int64_t number = 0;        // from 1
    std::array<double, 2> mouse{};  // px of the picture, from its bottom left
    int samples = 0;  // frames that accumulating passes hold already; 0: they start anew
    std::span<const BeamPoint> beam;
    bool is_first = false;  // no history, and no beam before this one
    std::array<double, 16> view{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  // by column
};
