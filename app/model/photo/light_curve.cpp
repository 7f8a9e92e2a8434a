#include "model/photo/light_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace {
double sum_of(glm::dvec3 light) {
    return light.r + light.g + light.b;
}

// The standard deviation of noise: the median of the second differences, which a decay hardly has.
double noise_of(const std::vector<glm::dvec3>& values, glm::length_t channel) {
    constexpr double least = 0.33 / 255.0;
    const double normal = std::sqrt(6.0) * 0.6745;  // median of such differences
    std::vector<double> differences;
    for (std::size_t i = 2; i < values.size(); ++i)
        differences.push_back(
            std::abs(values[i][channel] - 2.0 * values[i - 1][channel] + values[i - 2][channel]));
    if (differences.empty())
        return least;
    const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::ranges::nth_element(differences, middle);
    return std::max(least, *middle / normal);
}

// The standard deviation of a pixel's noise before it is cut off at black, from the darkest
// quarter of the frames.
double noise_in_the_dark(const PixelLight& pixels, glm::length_t channel) {
    // Of normal noise about black that is cut off, times the square root of 2 for changes.
    const double cut_off = std::sqrt(1.0 - 1.0 / std::numbers::pi);
    std::vector<std::size_t> frames(pixels.mean.size());
    std::iota(frames.begin(), frames.end(), std::size_t{0});
    std::ranges::sort(frames, {}, [&](std::size_t i) { return pixels.mean[i][channel]; });
    frames.resize(frames.size() / 4);
    double sum = 0.0;
    for (const std::size_t i : frames)
        sum += pixels.deviation[i][channel];
    return frames.empty() ? 0.0 : sum / static_cast<double>(frames.size()) / cut_off;
}

// The mean of normal noise whose mean is `seen` after negative values became 0.
double before_cut(double seen, double noise) {
    constexpr double lowest = -2.0;  // standard deviations
    if (noise <= 0.0)
        return seen;
    double mean = seen / noise;  // in standard deviations
    const double wanted = mean;
    for (int step = 0; step < 20; ++step) {
        const double share = 0.5 * std::erfc(-mean / std::numbers::sqrt2);  // that is not cut off
        const double density = std::exp(-0.5 * mean * mean) / std::sqrt(2.0 * std::numbers::pi);
        const double miss = mean * share + density - wanted;
        mean = std::max(mean - miss / std::max(share, 0.02), lowest);
    }
    return noise * mean;
}
}  // namespace

LightCurve light_curve(const PixelLight& pixels, double fps, double gamma) {
    constexpr double black = 4.0 / 255.0;  // darker values are not exact
    LightCurve curve{fps, pixels.mean, {}};
    curve.variance.resize(curve.light.size());
    std::vector<glm::dvec3> values;
    for (const glm::dvec3& rgb : curve.light)
        values.push_back(glm::pow(rgb, glm::dvec3(1.0 / gamma)));
    for (glm::length_t channel = 0; channel < 3; ++channel) {
        const double noise = noise_of(values, channel);
        const double cut = noise_in_the_dark(pixels, channel);
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double slope = gamma * std::pow(std::max(values[i][channel], black), gamma - 1.0);
            double& light = curve.light[i][channel];
            curve.variance[i][channel] =
                std::pow(slope * noise, 2) + std::pow(shared_light_error * light, 2);
            light = before_cut(light, cut);
        }
    }
    return curve;
}

namespace {
// As many dark frames as light ones: the background must be seen, and no more.
std::size_t end_of(const std::vector<double>& sums, std::size_t start) {
    constexpr double dark = 0.003;  // of the most light, above the least
    constexpr std::size_t least_dark = 12;
    const auto [least, most] = std::ranges::minmax(sums);
    std::size_t light = 0;
    for (std::size_t i = start; i < sums.size(); ++i)
        if (sums[i] - least > dark * most)
            light = i + 1 - start;
    return std::min(start + light + std::max(light, least_dark), sums.size());
}

LightCurve part_of(const LightCurve& curve, std::size_t start, std::size_t end) {
    const auto cut = [&](const std::vector<glm::dvec3>& values) {
        return std::vector<glm::dvec3>(values.begin() + static_cast<std::ptrdiff_t>(start),
                                       values.begin() + static_cast<std::ptrdiff_t>(end));
    };
    return {curve.fps, cut(curve.light), cut(curve.variance)};
}
}  // namespace

Result<RecordedDecay> recorded_decay(const LightCurve& curve) {
    constexpr double lit = 0.9;        // of the most light
    constexpr double still_lit = 0.5;  // without a dark frame since an earlier flash
    constexpr double least_light = 0.01;
    constexpr double least_fall = 0.5;
    constexpr std::size_t least_frames = 8;
    std::vector<double> sums;
    for (const glm::dvec3& light : curve.light)
        sums.push_back(sum_of(light));
    const double most = sums.empty() ? 0.0 : std::ranges::max(sums);
    if (most < least_light)
        return fail({{}, 0, "The video shows no light at this place."});
    std::size_t last = sums.size() - 1;
    while (sums[last] < lit * most)
        --last;
    std::size_t first = last;
    while (first > 0 && sums[first - 1] >= still_lit * most)
        --first;
    const auto lit_frames = static_cast<int>(last - first + 1);
    constexpr int flash = 2;  // frames
    const std::size_t start = last + (lit_frames > flash ? 2 : 1);
    if (start + least_frames > sums.size() || sums.back() > least_fall * most)
        return fail({{},
                     0,
                     "The video does not show how the light fades. Record the moment when it goes "
                     "off, and go on until it is dark."});
    return RecordedDecay{part_of(curve, start, end_of(sums, start)), lit_frames};
}
