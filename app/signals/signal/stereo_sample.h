#pragma once

/// Left and right (or channel 1 and channel 2) at one instant.
struct StereoSample {
    float left = 0.0f;
    float right = 0.0f;

    bool operator==(const StereoSample&) const = default;
};
