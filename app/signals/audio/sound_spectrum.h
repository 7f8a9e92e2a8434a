#pragma once

#include "signals/audio/beat_detector.h"
#include "signals/audio/spectrum.h"
#include "signals/signal/signal.h"

/// Settings of a spectrum display.
struct SpectrumControls {
    int size = 2048;  // samples per transform
    double smoothing_seconds = 0.1;
    double low_hertz = 20.0;
    double high_hertz = 20000.0;
    double floor_decibels = -80.0;  // at the bottom of the screen, or on the ring
    double ceiling_decibels = 0.0;
    bool is_radial = false;
    double radius = 0.4;  // of the ring
    double pulse = 0.3;   // how far a beat moves the ring, in radii
    double beat_threshold = 1.5;
    double beat_decay_seconds = 0.3;
};

/// The spectrum of a sound at 60 Hz. As a line, low frequencies are on the left. On a ring they are
/// at the top, and high frequencies at the bottom of both sides. The frequency scale is
/// logarithmic.
class SoundSpectrum : public Signal {
public:
    SoundSpectrum(std::shared_ptr<const SampleStream> sound, const SoundInputSettings& plug,
                  const SpectrumControls& controls);

    void trace(const TimeSpan& span, Beam& beam) const override;
    double seconds() const override { return m_input.seconds(); }

private:
    static constexpr std::int64_t points = 4096;  // per hop

    /// The frequency range of a column, in bins.
    struct Column {
        double low = 0.0;
        double high = 0.0;
    };
    void show_hop(std::int64_t hop) const;
    double decibels_of(const Column& column, const std::vector<float>& amplitudes) const;
    BeamPoint on_line(std::int64_t index) const;
    BeamPoint on_ring(std::int64_t index) const;

    SoundInput m_input;
    SpectrumControls m_controls;
    Spectrum m_spectrum;
    BeatDetector m_beats;
    double m_charge;
    std::vector<Column> m_columns;
    mutable std::int64_t m_hop = INT64_MIN;  // of m_levels and m_ring
    mutable std::vector<float> m_levels;     // of its columns, 0 floor .. 1 ceiling
    mutable double m_ring = 0.0;             // radius of the ring
};
