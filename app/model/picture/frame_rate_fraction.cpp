#include "model/picture/frame_rate_fraction.h"

#include <cmath>

FrameRateFraction frame_rate_fraction(double fps) {
    constexpr int largest = 100000;
    constexpr double tolerance = 1e-9;
    FrameRateFraction nearest{static_cast<int>(std::lround(fps)), 1};
    for (int below = 1; below <= largest; ++below) {
        const FrameRateFraction rate{static_cast<int>(std::lround(fps * below)), below};
        const double error = std::abs(rate.number() - fps);
        if (error < std::abs(nearest.number() - fps))
            nearest = rate;
        if (error <= tolerance * fps)
            return rate;
    }
    return nearest;
}
