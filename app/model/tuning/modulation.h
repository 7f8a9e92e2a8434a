#pragma once

#include "model/look/look.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

enum class ModulationKind { lfo, envelope, beat };
enum class LfoShape { sine, triangle, saw, square, random };

/// What moves a parameter by itself, about the value that a person gave it. A figure that its kind
/// does not have is as it is here.
struct Modulation {
    ModulationKind kind = ModulationKind::lfo;
    double depth = 0.25;  // of the parameter's range; below 0 it goes the other way
    // lfo: -1..1
    LfoShape shape = LfoShape::sine;
    double rate = 0.5;   // Hz
    double phase = 0.0;  // turns
    // envelope: 0..1, the level of what is heard; beat: 1 at each beat, then down to 0
    double attack = 0.01;    // s, time constants
    double release = 0.3;    // s
    double threshold = 2.0;  // of a beat's energy, times the mean

    bool operator==(const Modulation&) const = default;
};

/// By parameter name.
using Modulations = std::map<std::string, Modulation>;

/// One number of a kind of modulation: what a file, a control and the manual say about it.
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
const std::vector<ModulationFigure>& figures_of(ModulationKind kind);

/// A choice among words: how a file has it, and how a person reads it.
template <class T>
struct ModulationWord {
    T value;
    std::string key;
    std::string label;
};
const std::vector<ModulationWord<ModulationKind>>& modulation_kinds();
const std::vector<ModulationWord<LfoShape>>& lfo_shapes();

/// "LFO, sine, rate 0.5 Hz, depth 0.25".
std::string summary_of(const Modulation& modulation);

/// Within the limits of its figures, and without those of other kinds.
Modulation tidied(const Modulation& modulation);

/// Why a parameter can't be modulated, as a sentence; "" when it can. Numbers can, except those
/// that set the sizes and repeat counts of passes: their targets would be allocated in every frame.
std::string why_unmodulated(const Look& look, const Parameter& parameter);

/// How loud it is, 0 silence .. 1 full scale: pure functions of the time of what is heard, however
/// that is cut into frames.
class Loudness {
public:
    virtual ~Loudness() = default;
    /// What follows the peaks up with one time constant and down with another one, in seconds.
    virtual double envelope(double seconds, double attack, double release) const = 0;
    /// Since the last beat, which has so many times the mean's energy; none when it is long ago.
    virtual std::optional<double> seconds_since_beat(double seconds, double threshold) const = 0;
};

/// Where an LFO is then, -1..1. It begins as its phase says at time 0. `seed` tells one that steps
/// at random from others.
double lfo_at(const Modulation& modulation, double seconds, std::uint64_t seed);

/// The values as they are then: each modulated one is its own + depth * range * (-1..1 of an LFO,
/// 0..1 of the others), all components alike, within its hard limit. Without loudness it is silent.
Values modulated(const Look& look, Values values, const Modulations& modulations, double seconds,
                 const Loudness* loudness);
