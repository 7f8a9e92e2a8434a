#pragma once

/// The tempo of the picture: beats on its clock.
struct Tempo {
    double bpm = 120.0;     // beats (quarter notes) per minute
    double downbeat = 0.0;  // s on the clock, where a bar begins; any sign
    double beats_per_bar = 4.0;

    bool operator==(const Tempo&) const = default;
    double seconds_per_beat() const { return 60.0 / bpm; }
    /// Beats since the downbeat; negative before it.
    double beats_at(double seconds) const { return (seconds - downbeat) * bpm / 60.0; }
    double bars_at(double seconds) const { return beats_at(seconds) / beats_per_bar; }
    double seconds_at(double beats) const { return downbeat + beats * seconds_per_beat(); }
};

constexpr double min_bpm = 20.0;
constexpr double max_bpm = 400.0;
constexpr double max_beats_per_bar = 16.0;

/// Another tempo from `seconds` on: the beat continues there without a jump.
Tempo with_bpm(const Tempo& tempo, double bpm, double seconds);
/// A bar begins at `seconds`.
Tempo with_downbeat(const Tempo& tempo, double seconds);
/// Finite and within the limits.
Tempo normalised(const Tempo& tempo);
