#pragma once

/// The cost of the latest frames, for deciding how much time the next one may cover.
struct FrameCost {
    double wall_seconds = 0.0;  // from one frame to the next
    double beam_seconds = 0.0;  // the part for making and drawing the points
    double span_seconds = 0.0;  // of the signal that the points cover
};

/// The longest time that a frame may cover, 1/60 to 1/4 s. The longer a frame takes, the more
/// points the next one has to draw. On a slow machine each frame would take longer than the
/// previous one. Points therefore get half of the time of the rest of the frame, or 2/60 s if that
/// is longer.
double longest_frame(const FrameCost& cost);
