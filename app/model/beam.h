#pragma once

#include <vector>

/// Where the beam was at one instant of a frame; the attributes of `points` and `segments` passes.
struct BeamPoint {
    float x = 0.0f;  // -1 left .. 1 right
    float y = 0.0f;  // -1 bottom .. 1 top
    float intensity =
        0.0f;  // charge laid down: 1 is full current for 1/4096 of 1/60 s; 0 is blanked
    float age_seconds = 0.0f;  // before the frame's end

    bool operator==(const BeamPoint&) const = default;
};

using Beam = std::vector<BeamPoint>;
