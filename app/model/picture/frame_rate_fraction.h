#pragma once

#include <string>

/// Frames per second as a fraction of two integers, as in films: 30000/1001.
struct FrameRateFraction {
    int above = 60;
    int below = 1;

    double number() const { return static_cast<double>(above) / below; }
    /// "30000/1001" for '/'.
    std::string text(char between) const {
        return std::to_string(above) + between + std::to_string(below);
    }
};

/// The fraction with the smallest denominator whose relative error is at most 1e-9; up to 1000 fps.
FrameRateFraction frame_rate_fraction(double fps);
