#include "signals/audio/sound_spectrum.h"

#include "signals/signal/points.h"
#include "signals/signal/sine.h"

#include <cmath>

SoundSpectrum::SoundSpectrum(std::shared_ptr<const SampleStream> sound,
                             const SoundInputSettings& plug, const SpectrumControls& controls)
    : m_input(std::move(sound), plug),
      m_controls(controls),
      m_spectrum(m_input, controls.size, controls.smoothing_seconds),
      m_beats(m_input, controls.beat_threshold),
      m_charge(charge_of_point(points * Spectrum::hops_per_second)),
      m_levels(static_cast<std::size_t>(points)) {
    const double octaves = std::log2(controls.high_hertz / controls.low_hertz);
    const auto bin_at = [&](std::int64_t column) {
        const double across = static_cast<double>(column) / points;
        return controls.low_hertz * std::exp2(octaves * across) / m_spectrum.hertz_per_bin();
    };
    for (std::int64_t i = 0; i < points; ++i)
        m_columns.push_back({bin_at(i), bin_at(i + 1)});
}

// The loudest of a column's bins. Interpolates linearly in decibels between two bins.
double SoundSpectrum::decibels_of(const Column& column,
                                  const std::vector<float>& amplitudes) const {
    const auto last = amplitudes.size() - 1;
    if (column.low >= static_cast<double>(last))
        return m_controls.floor_decibels;  // above the Nyquist frequency
    const auto below = static_cast<std::size_t>(column.low);
    const auto end = std::min(static_cast<std::size_t>(column.high), last);
    if (end == below) {
        const double between = 0.5 * (column.low + column.high) - static_cast<double>(below);
        return std::lerp(decibels(amplitudes[below]), decibels(amplitudes[below + 1]), between);
    }
    float loudest = 0.0f;
    for (std::size_t bin = below + 1; bin <= end; ++bin)
        loudest = std::max(loudest, amplitudes[bin]);
    return decibels(loudest);
}

void SoundSpectrum::show_hop(std::int64_t hop) const {
    m_hop = hop;
    const std::vector<float>& amplitudes = m_spectrum.amplitudes(hop);
    const double range = m_controls.ceiling_decibels - m_controls.floor_decibels;
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const double above = decibels_of(m_columns[i], amplitudes) - m_controls.floor_decibels;
        m_levels[i] = static_cast<float>(std::clamp(above / range, 0.0, 1.0));
    }
    if (!m_controls.is_radial)
        return;
    const double now = static_cast<double>(hop) / Spectrum::hops_per_second;
    const auto beat = m_beats.last_beat(now);
    const double push =
        beat ? m_controls.pulse * std::exp((*beat - now) / m_controls.beat_decay_seconds) : 0.0;
    m_ring = m_controls.radius * (1.0 + push);
}

BeamPoint SoundSpectrum::on_line(std::int64_t index) const {
    const SweepPoint point = sweep_point(index, points, m_charge);
    return {point.x, 2.0f * m_levels[static_cast<std::size_t>(index)] - 1.0f, point.intensity};
}

BeamPoint SoundSpectrum::on_ring(std::int64_t index) const {
    const double turns = static_cast<double>(index + 1) / points;
    const double along = 1.0 - std::abs(2.0 * turns - 1.0);  // 0 at the top .. 1 at the bottom
    const auto column = static_cast<std::size_t>(along * (points - 1));
    const double room = std::max(1.0 - m_controls.radius * (1.0 + m_controls.pulse), 0.0);
    const double radius = m_ring + room * m_levels[column];
    return {static_cast<float>(radius * sine(turns)), static_cast<float>(radius * cosine(turns)),
            static_cast<float>(m_charge)};
}

void SoundSpectrum::trace(const TimeSpan& span, Beam& beam) const {
    PointStream stream{.rate = points * Spectrum::hops_per_second};
    if (std::isfinite(seconds()))
        stream.count = static_cast<std::int64_t>(seconds() * stream.rate);
    trace_points(span, stream, beam, [this](std::int64_t point) {
        const std::int64_t hop = point / points;
        if (hop != m_hop)
            show_hop(hop);
        return m_controls.is_radial ? on_ring(point % points) : on_line(point % points);
    });
}
