#include "model/picture/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

Statistics statistics_of(const Picture& picture) {
    Statistics all;
    double minimum = std::numeric_limits<double>::infinity();
    double maximum = -minimum;
    double sum = 0.0;
    const auto channels = static_cast<std::size_t>(picture.channels);
    for (std::size_t i = 0; i + channels <= picture.pixels.size(); i += channels) {
        const std::span<const float> pixel(&picture.pixels[i], channels);
        if (std::ranges::any_of(pixel, [](float number) { return std::isnan(number); })) {
            ++all.not_a_number;
        } else if (std::ranges::any_of(pixel, [](float number) { return std::isinf(number); })) {
            ++all.infinite;
        } else {
            ++all.finite;
            for (const auto number : pixel) {
                minimum = std::min(minimum, static_cast<double>(number));
                maximum = std::max(maximum, static_cast<double>(number));
                sum += static_cast<double>(number);
            }
        }
    }
    if (all.finite > 0) {
        all.minimum = minimum;
        all.maximum = maximum;
        all.mean = sum / static_cast<double>(all.finite * channels);
    }
    return all;
}

std::uint32_t Histogram::highest() const {
    std::uint32_t maximum = 0;
    for (const auto& channel : bins)
        for (const std::uint32_t count : channel)
            maximum = std::max(maximum, count);
    return maximum;
}

Histogram histogram_of(const Picture& picture, double low, double high, std::size_t bins) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    Histogram histogram{std::vector(channels, std::vector<std::uint32_t>(bins))};
    const double bins_per_unit = static_cast<double>(bins) / (high - low);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const auto number = static_cast<double>(picture.pixels[i]);
        if (!std::isfinite(number))
            continue;
        ++histogram.finite;
        if (number < low) {
            ++histogram.below;
        } else if (number > high) {
            ++histogram.above;
        } else {
            const auto bin = static_cast<std::size_t>((number - low) * bins_per_unit);
            ++histogram.bins[i % channels][std::min(bin, bins - 1)];
        }
    }
    return histogram;
}
