#include "formats/shadertoy_export/shadertoy_signal.h"

#include "base/text.h"
#include "glsl/constants/constants.h"
#include "signals/signal_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {
constexpr int most_points = 16384;

// States are phases in turns, because functions of a large time are not exact.
constexpr const char* lissajous_text = R"(
// Turns of both sines in 1/60 s.
vec2 signal_rates() {
    return vec2(signal_x + signal_speed / 60.0, signal_y);
}

// The current falls with the speed of the beam, relative to both deflections at their maximum.
float signal_current(vec2 turns) {
    vec2 rates = signal_rates();
    float speed = length(rates * cos(6.28318530718 * turns)) / max(length(rates), 1e-9);
    return 0.3 + 0.7 * 0.05 / (speed + 0.05);
}

vec4 signal_state(vec4 start, float time) {
    return vec4(fract(start.xy + signal_rates() * time), 0.0, 0.0);
}

vec3 signal_point(vec4 start, float time, float step) {
    vec2 turns = fract(signal_state(start, time).xy + vec2(signal_phase, 0.0));
    float current = signal_is_weighted ? signal_current(turns) : 1.0;
    return vec3(signal_amplitude * sin(6.28318530718 * turns), current);
}
)";

// After signal_rates(), the turns of two waves in a sweep, and signal_wave(). A sweep takes 1/60 s.
constexpr const char* one_channel_text = R"(
// x: the place in the sweep. yz: turns of the waves at its start; in XY mode those of now.
vec4 signal_state(vec4 start, float time) {
    if (signal_is_xy)
        return vec4(0.0, fract(start.yz + signal_rates() * time), 0.0);
    float sweeps = start.x + time;
    float whole = floor(sweeps + 1e-4);
    float place = sweeps - whole < 1e-4 ? 0.0 : sweeps - whole;
    return vec4(place, fract(start.yz + signal_rates() * (signal_speed / 60.0 * whole)), 0.0);
}

// The first point of a sweep is blanked. The others have its light.
vec3 signal_point(vec4 start, float time, float step) {
    vec2 rates = signal_rates();
    if (signal_is_xy) {
        vec2 turns = start.yz + rates * time;
        vec2 before = turns - rates * (0.25 / rates.x);
        return vec3(signal_amplitude * vec2(signal_wave(turns), signal_wave(before)), 1.0);
    }
    float sweeps = start.x + time;
    float whole = floor(sweeps - 1e-5);  // a sweep ends with its last point
    float across = sweeps - whole;
    vec2 turns = start.yz + rates * (across + signal_speed / 60.0 * whole);
    float current = across < 1.5 * step ? 0.0 : 1.0 / (1.0 - step);
    return vec3(2.0 * across - 1.0, signal_amplitude * signal_wave(turns), current);
}
)";

constexpr const char* carrier_rates =
    "\nvec2 signal_rates() {\n    return vec2(signal_carrier, signal_modulator);\n}\n";

constexpr const char* am_wave = R"(
float signal_wave(vec2 turns) {
    vec2 waves = sin(6.28318530718 * fract(turns));
    return (1.0 + signal_depth * waves.y) / (1.0 + signal_depth) * waves.x;
}
)";

constexpr const char* fm_wave = R"(
float signal_wave(vec2 turns) {
    float slow = sin(6.28318530718 * fract(turns.y));
    return sin(6.28318530718 * fract(turns.x) + signal_index * slow);
}
)";

constexpr const char* harmonics_wave = R"(
vec2 signal_rates() {
    return vec2(signal_base, 0.0);
}

// The shapes: 0 has all harmonics, 1 odd ones, 2 odd ones with alternating signs.
float signal_wave(vec2 turns) {
    float sum = 0.0;
    for (int n = 1; n <= int(signal_count); n += signal_shape == 0 ? 1 : 2) {
        float strength = pow(float(n), -signal_falloff);
        if (signal_shape == 2 && n % 4 == 3)
            strength = -strength;
        sum += strength * sin(6.28318530718 * fract(float(n) * fract(turns.x)));
    }
    return sum / signal_peak;
}
)";

double number_of(const Spec& signal, const std::string& key) {
    return std::get<double>(signal.settings.at(key));
}

const std::string& word_of(const Spec& signal, const std::string& key) {
    return std::get<std::string>(signal.settings.at(key));
}

std::string number_text(const SettingInfo& info, double value) {
    std::string text =
        fmt::format("const float signal_{} = {};  // @range {} {} @label \"{}\"", info.key,
                    glsl_number({}, value), format_number(std::min(info.low, value)),
                    format_number(std::max(info.high, value)), info.label);
    if (!info.unit.empty())
        text += fmt::format(" @unit \"{}\"", info.unit);
    return text + " @group \"Signal\"\n    // @help \"" + info.help + "\"\n";
}

std::string switch_text(const char* name, const char* label, bool value) {
    return fmt::format("const bool signal_{} = {};  // @label \"{}\" @group \"Signal\"\n", name,
                       value, label);
}

int shape_of(const Spec& signal) {
    const std::string& shape = word_of(signal, "shape");
    return shape == "saw" ? 0 : shape == "square" ? 1 : 2;
}

// The largest value of the sum, which the program divides by.
double peak_of(const Spec& signal) {
    constexpr int entries = 32768;
    const int shape = shape_of(signal);
    double peak = 0.0;
    for (int i = 0; i < entries; ++i) {
        double sum = 0.0;
        for (int n = 1; n <= static_cast<int>(number_of(signal, "count"));
             n += shape == 0 ? 1 : 2) {
            const double sign = shape == 2 && n % 4 == 3 ? -1.0 : 1.0;
            const double turns = static_cast<double>(i) * n / entries;
            sum += sign * std::pow(n, -number_of(signal, "falloff")) *
                   std::sin(2.0 * std::numbers::pi * turns);
        }
        peak = std::max(peak, std::abs(sum));
    }
    return peak;
}

// "": no formula.
std::string functions_of(const Spec& signal) {
    if (signal.kind == "lissajous")
        return switch_text("is_weighted", "Weighting by speed",
                           word_of(signal, "weighting") == "speed") +
               lissajous_text;
    const auto one_channel = [&](const std::string& wave) {
        return switch_text("is_xy", "XY mode", word_of(signal, "mode") == "xy") + wave +
               one_channel_text;
    };
    if (signal.kind == "am")
        return one_channel(std::string(carrier_rates) + am_wave);
    if (signal.kind == "fm")
        return one_channel(std::string(carrier_rates) + fm_wave);
    if (signal.kind == "harmonics")
        return fmt::format(
                   "const int signal_shape = {};\nconst float signal_peak = {};  // of the "
                   "sum, for these settings\n",
                   shape_of(signal), glsl_number({}, peak_of(signal))) +
               one_channel(harmonics_wave);
    return {};
}
}  // namespace

Result<ShadertoySignal> shadertoy_signal(const Spec& signal) {
    const std::string functions = functions_of(signal);
    if (functions.empty())
        return fail({{},
                     0,
                     fmt::format("the signal '{}' isn't a formula that Shadertoy can draw: "
                                 "lissajous, harmonics, am and fm are. Export it with --to web.",
                                 signal.kind)});
    ShadertoySignal made;
    made.points = static_cast<int>(number_of(signal, "points"));
    if (made.points > most_points)
        return fail({{},
                     0,
                     fmt::format("the signal has {} points, and Shadertoy can draw {}. Set the "
                                 "signal's points, or export it with --to web.",
                                 made.points, most_points)});
    for (const SettingInfo& info : find_kind(signal.kind)->settings)
        if (info.type == SettingType::number && info.key != "points")
            made.text += number_text(info, number_of(signal, info.key));
    made.text += functions;
    return made;
}
