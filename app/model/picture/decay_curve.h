#pragma once

#include <optional>
#include <span>

/// The decay of light after a flash. Times in seconds after the peak.
struct DecayCurve {
    double peak = 0.0;               // light
    double peak_seconds = 0.0;       // in the time of the samples
    std::optional<double> to_tenth;  // until the light stays at or below a tenth of the peak
    std::optional<double> to_hundredth;
    std::optional<double> to_thousandth;
    std::optional<double> half_life;  // of the best exponential fit down to a hundredth

    bool operator==(const DecayCurve&) const = default;
};

/// For samples of light at ascending times, with exponential interpolation. Levels not reached
/// within the samples are nullopt. The fit is a line through the logarithms, by least squares. It
/// is nullopt if the light does not decrease, or decays within one sample.
DecayCurve decay_curve(std::span<const double> seconds, std::span<const double> light);
