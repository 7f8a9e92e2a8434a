#pragma once

#include "model/look/look.h"
#include "model/tuning/tempo.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

enum class ModulationKind { lfo, envelope, beat };
enum class LfoShape { sine, triangle, saw, square, random };

/// Varies a parameter automatically around the value that the user set. Figures that its kind does
/// not use keep these defaults.
struct Modulation {
    ModulationKind kind = ModulationKind::lfo;
    double depth = 0.25;  // relative to the parameter's range; negative values invert it
    // lfo: -1..1
    LfoShape shape = LfoShape::sine;
    double rate = 0.5;   // Hz
    double phase = 0.0;  // turns
    // envelope: 0..1, the level of the sound; beat: 1 at each beat, then decays to 0
    double attack = 0.01;    // s, time constants
    double release = 0.3;    // s
    double threshold = 2.0;  // energy of a beat, relative to the mean
    // In beats of the tempo instead of Hz and seconds.
    bool is_in_beats = false;
    double period = 4.0;  // beats, of an LFO
    double attack_beats = 0.0625;
    double release_beats = 0.5;

    bool operator==(const Modulation&) const = default;
};

/// By parameter name.
using Modulations = std::map<std::string, Modulation>;

/// One number of a kind of modulation, as described in files, controls and the manual.
struct ModulationFigure {
    std::string key;
    std::string label;
    std::string unit;
    std::string help;
    double Modulation::*number = nullptr;
    Range range;  // of its slider
    Limit limit;
    Scale scale = Scale::linear;
};
const std::vector<ModulationFigure>& figures_of(ModulationKind kind, bool is_in_beats = false);
inline const std::vector<ModulationFigure>& figures_of(const Modulation& modulation) {
    return figures_of(modulation.kind, modulation.is_in_beats);
}

/// A musical length with its label: "1/16" to "8 bars".
struct NoteLength {
    double beats = 1.0;
    std::string label;
};
/// From the shortest to the longest.
std::vector<NoteLength> note_lengths(double beats_per_bar);

/// An option with its key in files and its label.
template <class T>
struct ModulationName {
    T value;
    std::string key;
    std::string label;
};
const std::vector<ModulationName<ModulationKind>>& modulation_kinds();
const std::vector<ModulationName<LfoShape>>& lfo_shapes();

/// Whether a modulation depends on the tempo.
bool uses_tempo(const Modulations& modulations);

/// "LFO, sine, rate 0.5 Hz, depth 0.25".
std::string summary_of(const Modulation& modulation);

/// Clamped to the limits of its figures, and without figures of other kinds.
Modulation normalised(const Modulation& modulation);

/// The reason why a parameter can't be modulated, as a sentence; "" if it can. Only numbers can,
/// except those for the size or repeat count of passes, which would reallocate targets each frame.
std::string why_unmodulated(const Look& look, const Parameter& parameter);

/// The level of the sound, 0 silence .. 1 full scale. Pure functions of the playback time,
/// independent of the frame rate.
class Loudness {
public:
    virtual ~Loudness() = default;
    /// Follows the peaks, with one time constant for rising and another for falling, in seconds.
    virtual double envelope(double seconds, double attack, double release) const = 0;
    /// Since the last beat, with at least `threshold` times the mean energy; nullopt if too long
    /// ago.
    virtual std::optional<double> seconds_since_beat(double seconds, double threshold) const = 0;
};

/// The value of an LFO, -1..1. It starts at its phase at time 0. `seed` distinguishes LFOs with
/// random steps.
double lfo_at(const Modulation& modulation, double seconds, std::uint64_t seed,
              const Tempo& tempo = {});

/// The values at this time. A modulated value is value + depth * range * (-1..1 for an LFO, 0..1
/// for others), for all components, within its hard limit. Null loudness: silence. Times in beats
/// that are longer than the limit in seconds are limited.
Values modulated(const Look& look, Values values, const Modulations& modulations, double seconds,
                 const Loudness* loudness, const Tempo& tempo = {});
