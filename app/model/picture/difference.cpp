#include "model/picture/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {
int colour_channels(const Picture& picture) {
    return std::min(picture.channels, 3);
}

float component(const Picture& picture, std::size_t pixel, int channel) {
    const int own = std::min(channel, colour_channels(picture) - 1);
    return picture
        .pixels[pixel * static_cast<std::size_t>(picture.channels) + static_cast<std::size_t>(own)];
}

double distance(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b)))
        return 0.0;
    const double apart = std::abs(static_cast<double>(a) - static_cast<double>(b));
    return std::isnan(apart) ? std::numeric_limits<double>::infinity() : apart;
}
}  // namespace

Distances distances_of(const DifferenceSums& sums, Extent extent, int channels) {
    const double pixels = static_cast<double>(extent.width) * extent.height;
    const double rms = std::sqrt(sums.squares / (pixels * channels));
    return {sums.absolute / (pixels * channels), rms, sums.largest, -20.0 * std::log10(rms),
            sums.beyond / pixels};
}

Result<Difference> difference_between(const Picture& first, const Picture& second,
                                      double tolerance) {
    if (first.extent != second.extent)
        return fail({{},
                     0,
                     fmt::format("the sizes differ: {} x {} and {} x {} px", first.extent.width,
                                 first.extent.height, second.extent.width, second.extent.height)});
    DifferenceSums sums;
    int largest_x = 0;
    int largest_y = 0;
    const int channels = std::max(colour_channels(first), colour_channels(second));
    const auto width = static_cast<std::size_t>(first.extent.width);
    const std::size_t pixels = width * static_cast<std::size_t>(first.extent.height);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        double worst = 0.0;
        for (int channel = 0; channel < channels; ++channel) {
            const double apart =
                distance(component(first, pixel, channel), component(second, pixel, channel));
            sums.absolute += apart;
            sums.squares += apart * apart;
            worst = std::max(worst, apart);
        }
        sums.beyond += worst > tolerance ? 1.0 : 0.0;
        if (worst > sums.largest) {
            sums.largest = worst;
            largest_x = static_cast<int>(pixel % width);
            largest_y = static_cast<int>(pixel / width);
        }
    }
    return Difference{distances_of(sums, first.extent, channels), largest_x, largest_y};
}

Picture difference_picture(const Picture& first, const Picture& second, double gain) {
    Picture apart{first.extent, 3, Encoding::display, {}};
    const std::size_t pixels = static_cast<std::size_t>(first.extent.width) *
                               static_cast<std::size_t>(first.extent.height);
    apart.pixels.reserve(pixels * 3);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
        for (int channel = 0; channel < 3; ++channel)
            apart.pixels.push_back(
                static_cast<float>(gain * distance(component(first, pixel, channel),
                                                   component(second, pixel, channel))));
    return apart;
}

double gain_to_see(double largest) {
    constexpr double max_stops = 16.0;
    if (!(largest > 0.0))
        return 1.0;
    return std::exp2(std::clamp(std::floor(-std::log2(largest)), 0.0, max_stops));
}
