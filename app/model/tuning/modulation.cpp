#include "model/tuning/modulation.h"

#include "base/text.h"
#include "model/plan/parameter_use.h"
#include "model/tuning/random_numbers.h"

#include <fmt/format.h>

#include <algorithm>
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

ModulationFigure release_figure(const Range& range, double longest) {
    return {.key = "release",
            .label = "Release",
            .unit = "s",
            .help = "Time to fall to 37 %.",
            .number = &Modulation::release,
            .range = range,
            .limit = {0.001, longest},
            .scale = Scale::logarithmic};
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
            {.key = "phase",
             .label = "Phase",
             .unit = "turns",
             .help = "Phase at time 0. One turn is a full cycle.",
             .number = &Modulation::phase,
             .range = {0.0, 1.0, 0.0},
             .limit = {0.0, 1.0}},
            depth_figure()};
}

Figures envelope_figures() {
    constexpr double longest = 2.0;
    return {{.key = "attack",
             .label = "Attack",
             .unit = "s",
             .help = "Time to rise by 63 % of the difference.",
             .number = &Modulation::attack,
             .range = {0.001, 1.0, 0.0},
             .limit = {0.001, longest},
             .scale = Scale::logarithmic},
            release_figure({0.01, longest, 0.0}, longest),
            depth_figure()};
}

Figures beat_figures() {
    constexpr double longest = 0.5;  // a beat is stored for two seconds
    return {{.key = "threshold",
             .label = "Threshold",
             .unit = "×",
             .help = "Bass energy that counts as a beat, relative to the mean of the last second.",
             .number = &Modulation::threshold,
             .range = {1.0, 8.0, 0.0},
             .limit = {0.1, 1000.0}},
            release_figure({0.02, longest, 0.0}, longest),
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

bool drives_size(const Look& look, const Parameter& parameter) {
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        if (affects_target_size(look, i, parameter))
            return true;
    return false;
}

// From the name without a scope, so that it is the same in every stack.
std::uint64_t seed_of(const std::string& name) {
    return digest_of(name.substr(name.rfind('/') + 1));
}

double amount_of(const Modulation& modulation, const std::string& name, double seconds,
                 const Loudness* loudness) {
    if (modulation.kind == ModulationKind::lfo)
        return lfo_at(modulation, seconds, seed_of(name));
    if (!loudness)
        return 0.0;
    if (modulation.kind == ModulationKind::envelope)
        return loudness->envelope(seconds, modulation.attack, modulation.release);
    const auto since = loudness->seconds_since_beat(seconds, modulation.threshold);
    return since ? std::exp(-*since / modulation.release) : 0.0;
}
}  // namespace

const std::vector<ModulationFigure>& figures_of(ModulationKind kind) {
    static const Figures lfo = lfo_figures();
    static const Figures envelope = envelope_figures();
    static const Figures beat = beat_figures();
    switch (kind) {
        case ModulationKind::envelope:
            return envelope;
        case ModulationKind::beat:
            return beat;
        case ModulationKind::lfo:
            break;
    }
    return lfo;
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

std::string summary_of(const Modulation& modulation) {
    std::string text = name_of(modulation_kinds(), modulation.kind).label;
    if (modulation.kind == ModulationKind::lfo)
        text += ", " + to_lower(name_of(lfo_shapes(), modulation.shape).label);
    for (const ModulationFigure& figure : figures_of(modulation.kind)) {
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
    if (tidy.kind == ModulationKind::lfo)
        tidy.shape = modulation.shape;
    for (const ModulationFigure& figure : figures_of(tidy.kind)) {
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

double lfo_at(const Modulation& modulation, double seconds, std::uint64_t seed) {
    const double turns = modulation.rate * seconds + modulation.phase;
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
                 const Loudness* loudness) {
    for (const auto& [name, modulation] : modulations) {
        const Parameter* parameter = find_parameter(look, name);
        if (!parameter || !why_unmodulated(look, *parameter).empty())
            continue;
        const double by = modulation.depth * amount_of(modulation, name, seconds, loudness);
        Value value = value_of(*parameter, values);
        for (std::size_t i = 0; i < value.numbers.size(); ++i) {
            const Range& range = range_of(*parameter, i);
            value.numbers[i] += by * (range.high - range.low);
        }
        values[name] = clamped(*parameter, std::move(value));
    }
    return values;
}
