#pragma once

/// What the latest frames took, for deciding how much time the next may cover.
struct FrameCost {
    double wall_seconds = 0.0;  // from one frame to the next
    double beam_seconds = 0.0;  // of it: making and drawing the points
    double span_seconds = 0.0;  // of the signal that the points cover
};

/// The longest time that a frame may cover, 1/60 .. 1/4 s. The longer a frame takes, the more
/// points the next has to draw: on a slow machine each would take longer than the one before. So
/// the points get half of what the rest of the frame takes, or two frames of a usual display.
double longest_frame(const FrameCost& cost);
