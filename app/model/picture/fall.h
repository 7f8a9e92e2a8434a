#pragma once

#include <optional>
#include <span>

/// How light falls after a flash. Times in seconds, from the light's peak on.
struct Fall {
    double peak = 0.0;               // light
    double peak_seconds = 0.0;       // on the clock of the samples
    std::optional<double> to_tenth;  // until it stays at a tenth of the peak or below
    std::optional<double> to_hundredth;
    std::optional<double> to_thousandth;
    std::optional<double> half_life;  // of the exponential that fits best down to a hundredth

    bool operator==(const Fall&) const = default;
};

/// Of samples of light at times that go up. Between two samples light is taken to fall
/// exponentially; what is not reached within the samples is none. The fit is a straight line
/// through the logarithms, by least squares; a light that does not fall, or within one sample, has
/// none.
Fall fall_of(std::span<const double> seconds, std::span<const double> light);
