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

/// The smallest spot that a pass makes of the beam: the standard deviation of its light across and
/// up, where the signal's -1..1 is 2 long. 0: not known.
struct BeamSpot {
    double across = 0.0;
    double up = 0.0;

    bool operator==(const BeamSpot&) const = default;
};

/// The colour of the beam on its way to a point: linear factors of the look's own, 1 leaves it.
struct BeamTint {
    float r = 1.0f;
    float g = 1.0f;
    float b = 1.0f;

    bool operator==(const BeamTint&) const = default;
};

/// The points of some time, oldest first.
struct Beam : std::vector<BeamPoint> {
    using std::vector<BeamPoint>::vector;

    std::vector<BeamTint>
        tints;  // one for each point; none where the beam has no colour of its own
};
