#include "model/tuning/modulation.h"

#include "base/text.h"
#include "model/plan/parameter_use.h"
#include "model/tuning/random_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace {
using Figures = std::vector<ModulationFigure>;

ModulationFigure depth_figure() {
    return {.key = "depth",
            .label = "Depth",
            .unit = "",
            .help = "Change as a fraction of the parameter's range. Negative values invert it.",
            .number = &Modulation::depth,
            .range = {-1.0, 1.0, 0.0},
            .limit = {-4.0, 4.0}};
}

constexpr double longest_envelope = 2.0;  // s
constexpr double longest_decay = 0.5;     // s; a beat is stored for two seconds

ModulationFigure time_figure(const char* key, const char* label, const char* help,
                             double Modulation::*number, const Range& range, double longest) {
    return {.key = key,
            .label = label,
            .unit = "s",
            .help = help,
            .number = number,
            .range = range,
            .limit = {0.001, longest},
            .scale = Scale::logarithmic};
}

constexpr const char* attack_help = "Time to rise by 63 % of the difference.";
constexpr const char* release_help = "Time to fall to 37 %.";

// The same in beats.
ModulationFigure beats_figure(const char* key, const char* label, const char* help,
                              double Modulation::*number) {
    constexpr double shortest = 1.0 / 64.0;
    constexpr double longest = 32.0;
    return {.key = key,
            .label = label,
            .unit = "beats",
            .help = help,
            .number = number,
            .range = {shortest, 4.0, 0.0},
            .limit = {0.001, longest},
            .scale = Scale::logarithmic};
}

ModulationFigure phase_figure() {
    return {.key = "phase",
            .label = "Phase",
            .unit = "turns",
            .help = "Phase at time 0, or at the downbeat. One turn is a full cycle.",
            .number = &Modulation::phase,
            .range = {0.0, 1.0, 0.0},
            .limit = {0.0, 1.0}};
}

ModulationFigure threshold_figure() {
    return {.key = "threshold",
            .label = "Threshold",
            .unit = "×",
            .help = "Bass energy that counts as a beat, relative to the mean of the last second.",
            .number = &Modulation::threshold,
            .range = {1.0, 8.0, 0.0},
            .limit = {0.1, 1000.0}};
}

Figures lfo_figures() {
    return {{.key = "rate",
             .label = "Rate",
             .unit = "Hz",
             .help = "Cycles per second.",
             .number = &Modulation::rate,
             .range = {0.02, 20.0, 0.0},
             .limit = {0.001, 1000.0},
             .scale = Scale::logarithmic},
            phase_figure(),
            depth_figure()};
}

Figures lfo_figures_in_beats() {
    return {{.key = "period",
             .label = "Period",
             .unit = "beats",
             .help = "Length of a cycle in beats of the tempo. A beat is a quarter note.",
             .number = &Modulation::period,
             .range = {0.25, 32.0, 0.0},
             .limit = {1.0 / 64.0, 1024.0},
             .scale = Scale::logarithmic},
            phase_figure(),
            depth_figure()};
}

Figures envelope_figures() {
    return {time_figure("attack", "Attack", attack_help, &Modulation::attack, {0.001, 1.0, 0.0},
                        longest_envelope),
            time_figure("release", "Release", release_help, &Modulation::release,
                        {0.01, longest_envelope, 0.0}, longest_envelope),
            depth_figure()};
}

Figures envelope_figures_in_beats() {
    return {beats_figure("attack", "Attack", attack_help, &Modulation::attack_beats),
            beats_figure("release", "Release", release_help, &Modulation::release_beats),
            depth_figure()};
}

Figures beat_figures() {
    return {threshold_figure(),
            time_figure("release", "Release", release_help, &Modulation::release,
                        {0.02, longest_decay, 0.0}, longest_decay),
            depth_figure()};
}

Figures beat_figures_in_beats() {
    return {threshold_figure(),
            beats_figure("release", "Release", release_help, &Modulation::release_beats),
            depth_figure()};
}

template <class T>
const ModulationName<T>& name_of(const std::vector<ModulationName<T>>& names, T value) {
    return *std::ranges::find(names, value, &ModulationName<T>::value);
}

// The fraction of a cycle, 0 <= share < 1.
double share_of_turn(double turns) {
    return turns - std::floor(turns);
}

// From the name without a scope, so that it is the same in every stack.
std::uint64_t seed_of(const std::string& name) {
    return digest_of(name.substr(name.rfind('/') + 1));
}

// In seconds, at most `longest`.
double time_of(double beats, const Tempo& tempo, double longest) {
    return std::clamp(beats * tempo.seconds_per_beat(), 0.001, longest);
}

// The same modulation with times in seconds.
Modulation in_seconds(const Modulation& modulation, const Tempo& tempo) {
    Modulation seconds = modulation;
    if (!modulation.is_in_beats)
        return seconds;
    const bool is_beat = modulation.kind == ModulationKind::beat;
    seconds.attack = time_of(modulation.attack_beats, tempo, longest_envelope);
    seconds.release =
        time_of(modulation.release_beats, tempo, is_beat ? longest_decay : longest_envelope);
    return seconds;
}

double amount_of(const Modulation& modulation, const std::string& name, double seconds,
                 const Loudness* loudness, const Tempo& tempo) {
    if (modulation.kind == ModulationKind::lfo)
        return lfo_at(modulation, seconds, seed_of(name), tempo);
    if (!loudness)
        return 0.0;
    const Modulation timed = in_seconds(modulation, tempo);
    if (modulation.kind == ModulationKind::envelope)
        return loudness->envelope(seconds, timed.attack, timed.release);
    const auto since = loudness->seconds_since_beat(seconds, modulation.threshold);
    return since ? std::exp(-*since / timed.release) : 0.0;
}
}  // namespace

const std::vector<ModulationFigure>& figures_of(ModulationKind kind, bool is_in_beats) {
    static const std::array<Figures, 2> lfo{lfo_figures(), lfo_figures_in_beats()};
    static const std::array<Figures, 2> envelope{envelope_figures(), envelope_figures_in_beats()};
    static const std::array<Figures, 2> beat{beat_figures(), beat_figures_in_beats()};
    const std::size_t unit = is_in_beats ? 1 : 0;
    switch (kind) {
        case ModulationKind::envelope:
            return envelope[unit];
        case ModulationKind::beat:
            return beat[unit];
        case ModulationKind::lfo:
            break;
    }
    return lfo[unit];
}

std::vector<NoteLength> note_lengths(double beats_per_bar) {
    std::vector<NoteLength> lengths{{0.25, "1/16"}, {0.5, "1/8"}, {1.0, "1/4"}, {2.0, "1/2"}};
    for (const int bars : {1, 2, 4, 8})
        lengths.push_back(
            {bars * beats_per_bar, fmt::format("{} bar{}", bars, bars > 1 ? "s" : "")});
    std::ranges::stable_sort(lengths, {}, &NoteLength::beats);
    return lengths;
}

const std::vector<ModulationName<ModulationKind>>& modulation_kinds() {
    static const std::vector<ModulationName<ModulationKind>> names{
        {ModulationKind::lfo, "lfo", "LFO"},
        {ModulationKind::envelope, "envelope", "Sound level"},
        {ModulationKind::beat, "beat", "Beat"}};
    return names;
}

const std::vector<ModulationName<LfoShape>>& lfo_shapes() {
    static const std::vector<ModulationName<LfoShape>> names{
        {LfoShape::sine, "sine", "Sine"},
        {LfoShape::triangle, "triangle", "Triangle"},
        {LfoShape::saw, "saw", "Saw"},
        {LfoShape::square, "square", "Square"},
        {LfoShape::random, "random", "Random steps"}};
    return names;
}

bool uses_tempo(const Modulations& modulations) {
    return std::ranges::any_of(modulations,
                               [](const auto& entry) { return entry.second.is_in_beats; });
}

std::string summary_of(const Modulation& modulation) {
    std::string text = name_of(modulation_kinds(), modulation.kind).label;
    if (modulation.kind == ModulationKind::lfo)
        text += ", " + to_lower(name_of(lfo_shapes(), modulation.shape).label);
    for (const ModulationFigure& figure : figures_of(modulation)) {
        const bool is_close = figure.unit.empty() || figure.unit == "×";
        text +=
            fmt::format(", {} {}{}{}", to_lower(figure.label),
                        format_number(modulation.*figure.number), is_close ? "" : " ", figure.unit);
    }
    return text;
}

Modulation normalised(const Modulation& modulation) {
    Modulation tidy;
    tidy.kind = modulation.kind;
    tidy.is_in_beats = modulation.is_in_beats;
    if (tidy.kind == ModulationKind::lfo)
        tidy.shape = modulation.shape;
    for (const ModulationFigure& figure : figures_of(tidy)) {
        const double number = modulation.*figure.number;
        if (std::isfinite(number))
            tidy.*figure.number = std::clamp(number, figure.limit.low, figure.limit.high);
    }
    return tidy;
}

std::string why_unmodulated(const Look& look, const Parameter& parameter) {
    const std::string& name = parameter.name;
    switch (parameter.control) {
        case Control::list:
            return fmt::format("'{}' can't be modulated: it is a list", name);
        case Control::color:
            return fmt::format("'{}' can't be modulated: it is a colour", name);
        case Control::event:
            return fmt::format("'{}' can't be modulated: it is a button", name);
        case Control::image:
        case Control::sound:
            return fmt::format("'{}' can't be modulated: it is a file", name);
        case Control::slider:
        case Control::angle:
        case Control::point:
            break;
    }
    if (parameter.is_constant)
        return fmt::format("'{}' can't be modulated: changing it recompiles the look", name);
    if (parameter.type.scalar == Scalar::boolean)
        return fmt::format("'{}' can't be modulated: it is a switch", name);
    if (parameter.type.columns > 1)
        return fmt::format("'{}' can't be modulated: it is a matrix", name);
    if (drives_size(look, parameter))
        return fmt::format("'{}' can't be modulated: it sets the size or repeat count of a pass",
                           name);
    return "";
}

double lfo_at(const Modulation& modulation, double seconds, std::uint64_t seed,
              const Tempo& tempo) {
    const double cycles = modulation.is_in_beats ? tempo.beats_at(seconds) / modulation.period
                                                 : modulation.rate * seconds;
    const double turns = cycles + modulation.phase;
    const double share = share_of_turn(turns);
    switch (modulation.shape) {
        case LfoShape::sine:
            return std::sin(2.0 * std::numbers::pi * share);
        case LfoShape::triangle:  // in phase with the sine
            return 1.0 - 4.0 * std::abs(share_of_turn(turns + 0.25) - 0.5);
        case LfoShape::saw:
            return 2.0 * share - 1.0;
        case LfoShape::square:
            return share < 0.5 ? 1.0 : -1.0;
        case LfoShape::random:
            break;
    }
    const auto step = static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(turns)));
    constexpr std::uint64_t apart = 0xd1342543de82ef95u;  // odd: gives each step its own seed
    return 2.0 * RandomNumbers(seed ^ (step * apart)).next() - 1.0;
}

Values modulated(const Look& look, Values values, const Modulations& modulations, double seconds,
                 const Loudness* loudness, const Tempo& tempo) {
    for (const auto& [name, modulation] : modulations) {
        const Parameter* parameter = find_parameter(look, name);
        if (!parameter || !why_unmodulated(look, *parameter).empty())
            continue;
        const double by = modulation.depth * amount_of(modulation, name, seconds, loudness, tempo);
        Value value = value_of(*parameter, values);
        for (std::size_t i = 0; i < value.numbers.size(); ++i) {
            const Range& range = range_of(*parameter, i);
            value.numbers[i] += by * (range.high - range.low);
        }
        values[name] = clamped(*parameter, std::move(value));
    }
    return values;
}
