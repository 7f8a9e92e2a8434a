#pragma once

#include <vector>

/// The beam at one instant of a frame; the vertex attributes of `points` and `segments` passes.
struct BeamPoint {
    float x = 0.0f;            // -1 left .. 1 right
    float y = 0.0f;            // -1 bottom .. 1 top
    float intensity = 0.0f;    // charge: 1 is full current for 1/4096 of 1/60 s; 0 is blanked
    float age_seconds = 0.0f;  // at the frame's end

    bool operator==(const BeamPoint&) const = default;
};

/// The smallest beam spot of a pass: the horizontal and vertical standard deviation of its light,
/// where the signal's -1..1 has length 2. 0: unknown.
struct BeamSpot {
    double across = 0.0;
    double up = 0.0;

    bool operator==(const BeamSpot&) const = default;
};

/// The colour of the beam towards a point: linear factors of the look's own colour; 1 is unchanged.
struct BeamTint {
    float r = 1.0f;
    float g = 1.0f;
    float b = 1.0f;

    bool operator==(const BeamTint&) const = default;
};

/// The points of a time span, oldest first.
struct Beam : std::vector<BeamPoint> {
    using std::vector<BeamPoint>::vector;

    std::vector<BeamTint> tints;  // one per point; empty if the beam has no colour of its own
};
