#include "signals/audio/spectrum.h"

#include "signals/signal/sine.h"

#include <kissfft/kiss_fftr.h>

#include <algorithm>
#include <cmath>

namespace {
/// A window function as a sum of cosines.
struct Weights {
    double mean;
    double once;   // coefficient of the cosine with one period
    double twice;  // with two periods
};

// The Blackman window with alpha = 0.16, as in Web Audio.
Weights weights_of(SpectrumWindow window) {
    return window == SpectrumWindow::hann ? Weights{0.5, 0.5, 0.0} : Weights{0.42, 0.5, 0.08};
}
}  // namespace

struct Spectrum::Transform {
    Transform(std::size_t size, const Weights& weights)
        : plan(kiss_fftr_alloc(static_cast<int>(size), 0, nullptr, nullptr)),
          window(size),
          volts(size),
          samples(size),
          bins(size / 2 + 1) {
        for (std::size_t i = 0; i < size; ++i) {
            const double position = static_cast<double>(i) / static_cast<double>(size);
            window[i] = static_cast<float>(weights.mean - weights.once * cosine(position) +
                                           weights.twice * cosine(2.0 * position));
        }
    }
    ~Transform() { kiss_fftr_free(plan); }
    Transform(const Transform&) = delete;
    Transform& operator=(const Transform&) = delete;

    /// Transforms the last samples before `end`.
    void run(const SoundInput& input, std::int64_t end) {
        input.read_originals(end - static_cast<std::int64_t>(volts.size()), volts);
        for (std::size_t i = 0; i < volts.size(); ++i)
            samples[i] = volts[i].left * window[i];
        kiss_fftr(plan, samples.data(), bins.data());
    }

    kiss_fftr_cfg plan;
    std::vector<float> window;
    std::vector<StereoSample> volts;
    std::vector<float> samples;
    std::vector<kiss_fft_cpx> bins;
};

Spectrum::Spectrum(const SoundInput& input, int size, double smoothing_seconds,
                   SpectrumWindow window)
    : m_input(input),
      m_rate(input.rate() / input.factor()),
      m_hertz_per_bin(m_rate / size),
      m_kept(smoothing_seconds > 0.0 ? std::exp(-1.0 / (hops_per_second * smoothing_seconds))
                                     : 0.0),
      // Older hops contribute less than e^-10, 87 dB down.
      m_memory(static_cast<std::int64_t>(std::ceil(10.0 * smoothing_seconds * hops_per_second))),
      m_full_scale(2.0 / (weights_of(window).mean * size)),
      m_transform(std::make_unique<Transform>(static_cast<std::size_t>(size), weights_of(window))),
      m_amplitudes(m_transform->bins.size()) {}

Spectrum::~Spectrum() = default;

void Spectrum::smooth(std::int64_t hop) const {
    const double end = std::floor(static_cast<double>(hop) / hops_per_second * m_rate + 1e-6);
    m_transform->run(m_input, static_cast<std::int64_t>(end));
    for (std::size_t i = 0; i < m_amplitudes.size(); ++i) {
        const kiss_fft_cpx& bin = m_transform->bins[i];
        const double now = m_full_scale * std::hypot(bin.r, bin.i);
        m_amplitudes[i] = static_cast<float>(now + m_kept * (m_amplitudes[i] - now));
    }
}

const std::vector<float>& Spectrum::amplitudes(std::int64_t hop) const {
    if (hop < m_hop || hop > m_hop + m_memory + 1) {
        std::fill(m_amplitudes.begin(), m_amplitudes.end(), 0.0f);
        m_hop = hop - m_memory - 1;
    }
    while (m_hop < hop)
        smooth(++m_hop);
    return m_amplitudes;
}

double decibels(double amplitude) {
    return 20.0 * std::log10(std::max(amplitude, 1e-10));
}
