#include "model/photo/period_spectrum.h"

#include <kissfft/kiss_fftr.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {
constexpr int most_lines = 160;  // that are averaged
constexpr std::size_t padding = 8;

std::size_t padded(std::size_t length) {
    std::size_t size = 1;
    while (size < padding * length)
        size *= 2;
    return size;
}

float signal_of(const float* values, Along along) {
    return along == Along::rows ? 1.402F * values[2] - 1.772F * values[1] : values[0];
}

// A range of pixels in the middle.
struct Middle {
    int start;
    int end;
};
Middle middle_of(int length, double share) {
    const int start = static_cast<int>(0.5 * (1.0 - share) * length);
    return {start, length - start};
}

// The place of a maximum between entries, from the parabola through three logarithms.
double refined(const std::vector<double>& power, std::size_t at) {
    const double before = std::log(power[at - 1]);
    const double here = std::log(power[at]);
    const double after = std::log(power[at + 1]);
    const double bend = before - 2.0 * here + after;
    return static_cast<double>(at) + (bend < 0.0 ? 0.5 * (before - after) / bend : 0.0);
}
}  // namespace

PeriodSpectrum period_spectrum(const Picture& picture, Along along) {
    const bool is_row = along == Along::rows;
    const Extent extent = picture.extent;
    const Middle pixels = middle_of(is_row ? extent.width : extent.height, 0.5);
    const Middle lines = middle_of(is_row ? extent.height : extent.width, 0.5);
    const auto length = static_cast<std::size_t>(pixels.end - pixels.start);
    const std::size_t size = padded(length);
    PeriodSpectrum spectrum{1.0 / static_cast<double>(size),
                            std::vector<double>(size / 2 + 1, 0.0)};
    std::vector<float> signal(size, 0.0F);
    std::vector<kiss_fft_cpx> waves(size / 2 + 1);
    const kiss_fftr_cfg plan = kiss_fftr_alloc(static_cast<int>(size), 0, nullptr, nullptr);
    const int stride = std::max((lines.end - lines.start) / most_lines, 1);
    int count = 0;
    for (int line = lines.start; line < lines.end; line += stride, ++count) {
        float mean = 0.0F;
        for (std::size_t i = 0; i < length; ++i) {
            const int pixel = pixels.start + static_cast<int>(i);
            const std::size_t index =
                is_row ? picture.index(pixel, line) : picture.index(line, pixel);
            signal[i] = signal_of(&picture.pixels[index], along);
            mean += signal[i] / static_cast<float>(length);
        }
        for (std::size_t i = 0; i < length; ++i) {
            const double turn = (static_cast<double>(i) + 0.5) / static_cast<double>(length);
            const double window = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * turn);
            signal[i] = (signal[i] - mean) * static_cast<float>(window);
        }
        kiss_fftr(plan, signal.data(), waves.data());
        for (std::size_t i = 0; i < waves.size(); ++i)
            spectrum.power[i] += static_cast<double>(waves[i].r * waves[i].r) +
                                 static_cast<double>(waves[i].i * waves[i].i);
    }
    kiss_fftr_free(plan);
    for (double& power : spectrum.power)
        power = std::max(power / std::max(count, 1), 1e-20);
    return spectrum;
}

std::vector<double> peak_periods(const PeriodSpectrum& spectrum, double shortest, double longest,
                                 std::size_t count) {
    const std::vector<double>& power = spectrum.power;
    const auto end =
        std::min(static_cast<std::size_t>(1.0 / (shortest * spectrum.step)) + 1, power.size() - 2);
    const auto start =
        std::max(static_cast<std::size_t>(1.0 / (longest * spectrum.step)), std::size_t{2});
    std::vector<std::size_t> peaks;
    for (std::size_t i = start; i < end; ++i)
        if (power[i] > power[i - 1] && power[i] >= power[i + 1])
            peaks.push_back(i);
    std::ranges::sort(peaks, [&](std::size_t a, std::size_t b) { return power[a] > power[b]; });
    std::vector<double> periods;
    for (const std::size_t peak : peaks) {
        const double period = 1.0 / (refined(power, peak) * spectrum.step);
        const bool is_new = std::ranges::none_of(
            periods, [&](double other) { return std::abs(period / other - 1.0) < 0.04; });
        if (is_new && periods.size() < count)
            periods.push_back(period);
    }
    return periods;
}

double period_ratio(const PeriodSpectrum& one, const PeriodSpectrum& other, double period) {
    constexpr int steps = 400;       // of the frequency, on a logarithmic scale
    constexpr double widest = 1.25;  // ratio of frequencies around the period
    constexpr int shifts = 160;
    constexpr double largest = 1.1;
    const auto amplitude = [](const PeriodSpectrum& spectrum, double frequency) {
        const double at = frequency / spectrum.step;
        const auto index = std::min(static_cast<std::size_t>(at), spectrum.power.size() - 2);
        const double share = at - static_cast<double>(index);
        return std::sqrt((1.0 - share) * spectrum.power[index] + share * spectrum.power[index + 1]);
    };
    double best = -1.0;
    double best_ratio = 1.0;
    for (int shift = -shifts; shift <= shifts; ++shift) {
        const double ratio = std::pow(largest, static_cast<double>(shift) / shifts);
        double product = 0.0;
        for (int step = -steps; step <= steps; ++step) {
            const double frequency = std::pow(widest, static_cast<double>(step) / steps) / period;
            product += amplitude(one, frequency / ratio) * amplitude(other, frequency);
        }
        if (product > best) {
            best = product;
            best_ratio = ratio;
        }
    }
    return best_ratio;
}
