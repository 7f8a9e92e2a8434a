#include "signals/audio/upsampler.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace {
// The modified Bessel function of the first kind, order 0, by its power series.
double bessel(double x) {
    double sum = 1.0;
    double term = 1.0;
    for (int n = 1; term > 1e-12 * sum; ++n) {
        term *= (x / (2.0 * n)) * (x / (2.0 * n));
        sum += term;
    }
    return sum;
}

double sinc(double x) {
    const double angle = std::numbers::pi * x;
    return x == 0.0 ? 1.0 : std::sin(angle) / angle;
}

// The Kaiser window (J. F. Kaiser); beta 8 attenuates images by 80 dB.
double kaiser(double x) {
    constexpr double beta = 8.0;
    return std::abs(x) >= 1.0 ? 0.0 : bessel(beta * std::sqrt(1.0 - x * x)) / bessel(beta);
}
}  // namespace

Upsampler::Upsampler(std::shared_ptr<const SampleStream> sound, int factor)
    : m_sound(std::move(sound)), m_factor(factor) {
    assert(m_sound->length() > 0 && factor >= 1);
    for (int phase = 0; phase < factor; ++phase)
        m_phases.push_back(phase_of(static_cast<double>(phase) / factor));
}

// The weights sum to 1, so that a constant level stays exactly constant.
Upsampler::Phase Upsampler::phase_of(double fraction) {
    std::array<double, taps> weights{};
    double sum = 0.0;
    for (int tap = 0; tap < taps; ++tap) {
        const double distance = tap - before - fraction;
        weights[static_cast<std::size_t>(tap)] = sinc(distance) * kaiser(distance / (taps / 2.0));
        sum += weights[static_cast<std::size_t>(tap)];
    }
    Phase phase{};
    for (std::size_t i = 0; i < phase.size(); ++i)
        phase[i] = static_cast<float>(weights[i / 2] / sum);
    return phase;
}

// Eight independent sums: the compiler vectorises them, and the order of additions is fixed.
StereoSample Upsampler::filtered(const StereoSample* window, const Phase& phase) {
    std::array<float, 8> sums{};
    for (std::size_t i = 0; i < taps; i += 4) {
        const StereoSample* w = window + i;
        const std::array<float, 8> values{w[0].left, w[0].right, w[1].left, w[1].right,
                                          w[2].left, w[2].right, w[3].left, w[3].right};
        for (std::size_t lane = 0; lane < 8; ++lane)
            sums[lane] += values[lane] * phase[i * 2 + lane];
    }
    return {(sums[0] + sums[2]) + (sums[4] + sums[6]), (sums[1] + sums[3]) + (sums[5] + sums[7])};
}

void Upsampler::read(std::int64_t first, std::span<StereoSample> samples) const {
    Window window;
    std::int64_t index = first / m_factor - (first % m_factor < 0 ? 1 : 0);
    auto phase = static_cast<std::size_t>(first - index * m_factor);
    std::size_t written = 0;
    while (written < samples.size()) {
        m_sound->read(index - before, window);
        for (std::int64_t i = 0; i < block && written < samples.size(); ++i) {
            const StereoSample* at = window.data() + i;
            for (; phase < m_phases.size() && written < samples.size(); ++phase)
                samples[written++] = phase == 0 ? at[before] : filtered(at, m_phases[phase]);
            phase = 0;
        }
        index += block;
    }
}
