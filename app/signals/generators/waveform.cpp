#include "signals/generators/waveform.h"

#include "signals/generators/shape.h"
#include "signals/scope/scope.h"
#include "signals/signal/settings.h"

#include <cmath>
#include <limits>
#include <utility>

namespace {
struct Generator {
    Shape shape = Shape::off;
    double hertz = 0.0;
    double amplitude = 0.0;  // V
    double mean = 0.0;       // V
    double phase = 0.0;      // turns
    std::uint64_t seed = 0;
    Coupling coupling = Coupling::dc;  // of the connected channel

    bool is_on() const { return shape != Shape::off; }
    double added() const { return coupling == Coupling::dc ? mean : 0.0; }
    float at(double seconds, double scrolled_turns) const {
        if (coupling == Coupling::ground || !is_on())
            return 0.0f;
        const double turns = hertz * seconds + phase + scrolled_turns;
        return static_cast<float>(added() + amplitude * wave(shape, turns, seed));
    }
};

Generator generator_of(const Settings& settings, const std::string& number) {
    const double unit = settings.is("per", "second") ? 1.0 : 60.0;
    return {.shape = shape_named(settings.word("ch" + number)),
            .hertz = settings.number("f" + number) * unit,
            .amplitude = settings.number("a" + number),
            .mean = settings.number("d" + number),
            .phase = settings.number("p" + number),
            .seed = static_cast<std::uint64_t>(settings.whole("seed")) * 2 + (number == "2")};
}

// Seconds after time 0 at which the generator first fires the trigger; nullopt when it never does.
std::optional<double> first_trigger(const Generator& generator, const ScopeChannel& channel,
                                    const Trigger& trigger) {
    if (generator.coupling == Coupling::ground || generator.amplitude <= 0.0 ||
        generator.hertz <= 0.0)
        return std::nullopt;
    const double volts = channel.is_inverted ? -trigger.level : trigger.level;
    const double level = (volts - generator.added()) / generator.amplitude;
    const auto turns = crossing(generator.shape, level, trigger.is_rising != channel.is_inverted);
    if (!turns || generator.shape == Shape::noise)
        return turns;
    const double ahead = *turns - generator.phase;
    return (ahead - std::floor(ahead)) / generator.hertz;
}

// A wave triggers once per period, so the sweeps are evenly spaced. Each sweep starts at the first
// trigger after the scope is ready again.
std::unique_ptr<Sweeps> sweeps_of(const ScopeControls& controls,
                                  const std::array<Generator, 2>& inputs, double rate) {
    const Trigger& trigger = controls.trigger;
    const double sweep = controls.sweep_seconds();
    const double busy = sweep + trigger.holdoff_seconds;
    if (trigger.mode == Trigger::Mode::off)
        return std::make_unique<PeriodicSweeps>(0.0, sweep * rate, sweep * rate);
    const std::size_t shown = inputs[0].is_on() ? 0 : 1;
    const std::size_t watched =
        trigger.source == 0 ? shown : static_cast<std::size_t>(trigger.source - 1);
    const Generator& source = inputs[watched];
    const auto first = first_trigger(source, controls.channels[watched], trigger);
    if (!first && trigger.mode == Trigger::Mode::automatic)
        return std::make_unique<PeriodicSweeps>(0.0, busy * rate, sweep * rate);
    if (!first)
        return std::make_unique<NoSweeps>();
    double period = busy;
    if (source.shape != Shape::noise)
        period = std::ceil(busy * source.hertz - 1e-6) / source.hertz;
    if (trigger.mode == Trigger::Mode::single)
        period = PeriodicSweeps::once;
    return std::make_unique<PeriodicSweeps>(*first * rate, period * rate, sweep * rate);
}

class Waveform : public Signal {
public:
    explicit Waveform(const Settings& settings)
        : Waveform(settings, scope_controls(settings),
                   {generator_of(settings, "1"), generator_of(settings, "2")}) {}

    void trace(const TimeSpan& span, Beam& beam) const override {
        constexpr auto endless = std::numeric_limits<std::int64_t>::max();
        m_scope.trace(span, endless, *m_sweeps, beam, [this](std::int64_t sample, double start) {
            const double seconds = static_cast<double>(sample + 1) / m_scope.rate();
            const double drift = m_scroll * (m_is_xy ? seconds : start);
            const double drift_up = m_is_xy ? 0.0 : drift;
            return StereoSample{m_inputs[0].at(seconds, drift), m_inputs[1].at(seconds, drift_up)};
        });
    }

    Repetition repetition() const override {
        Repetition repetition;
        if (!m_is_xy && m_sweeps->period() > 0.0)
            repetition.add(m_scope.rate() / m_sweeps->period());
        for (std::size_t i = 0; i < m_inputs.size(); ++i) {
            if (m_inputs[i].coupling == Coupling::ground || !m_inputs[i].is_on())
                continue;
            if (m_inputs[i].shape == Shape::noise)
                repetition.error = "noise never repeats. Choose another shape of the wave.";
            const bool scrolls = !m_is_xy || i == 0;
            repetition.add(m_inputs[i].hertz + (m_is_xy && scrolls ? m_scroll : 0.0));
            if (!m_is_xy)
                repetition.add(m_scroll);
        }
        return repetition;
    }

private:
    Waveform(const Settings& settings, const ScopeControls& controls,
             std::array<Generator, 2> inputs)
        : m_inputs(routed(controls, inputs)),
          m_scope(controls, {m_inputs[0].is_on(), m_inputs[1].is_on()},
                  settings.number("points") * 60.0 / traces(controls, m_inputs)),
          m_sweeps(sweeps_of(controls, m_inputs, m_scope.rate())),
          m_scroll(settings.number("speed")),
          m_is_xy(controls.is_xy) {}

    static std::array<Generator, 2> routed(const ScopeControls& controls,
                                           std::array<Generator, 2> inputs) {
        if (controls.is_swapped)
            std::swap(inputs[0], inputs[1]);
        for (std::size_t i = 0; i < 2; ++i)
            inputs[i].coupling = controls.channels[i].coupling;
        return inputs;
    }
    static double traces(const ScopeControls& controls, const std::array<Generator, 2>& inputs) {
        return !controls.is_xy && inputs[0].is_on() && inputs[1].is_on() ? 2.0 : 1.0;
    }

    std::array<Generator, 2> m_inputs;  // by the connected channel
    Scope m_scope;
    std::unique_ptr<Sweeps> m_sweeps;
    double m_scroll;  // turns per second
    bool m_is_xy;
};

std::vector<SettingInfo> generator_settings(const std::string& number, const std::string& shape,
                                            double frequency) {
    SettingInfo shapes =
        choice_setting("ch" + number, "Shape", "Shape of the wave.", shape_names());
    shapes.initial_word = shape;
    return {shapes,
            {.key = "f" + number,
             .label = "Frequency",
             .help = "Periods per 1/60 s or per second, see Frequency unit.",
             .low = 0.5,
             .high = 20,
             .initial = frequency,
             .limit = {0, 100000}},
            {.key = "a" + number,
             .label = "Amplitude",
             .unit = "V",
             .help = "From the middle to the peak.",
             .initial = 0.7,
             .limit = {0, 1000}},
            {.key = "p" + number,
             .label = "Phase",
             .unit = "turns",
             .help = "Phase at time 0. Triggering on this wave hides it."},
            {.key = "d" + number,
             .label = "DC offset",
             .unit = "V",
             .help = "Voltage added to the wave. AC coupling removes it.",
             .low = -1,
             .high = 1,
             .limit = {-1000, 1000}}};
}

std::vector<SettingInfo> shared_settings() {
    return {choice_setting("per", "Frequency unit",
                           "frame: periods per 1/60 s, so whole numbers stand still. second: Hz.",
                           {"frame", "second"}),
            {.key = "speed",
             .label = "Scroll",
             .unit = "periods/s",
             .help = "Speed of the traces to the left. In XY mode, of channel 1 relative to 2.",
             .low = -2,
             .high = 2,
             .limit = {-1000, 1000}},
            {.key = "seed",
             .label = "Noise seed",
             .help = "Each number gives a different noise.",
             .low = 1,
             .high = 100,
             .step = 1,
             .initial = 1,
             .limit = {0, 1e6}},
            points_setting()};
}

std::vector<SettingInfo> all_settings() {
    std::vector<SettingInfo> settings{choice_setting(
        "mode", "Mode", "yt: traces over time. xy: channel 1 horizontal, channel 2 vertical.",
        {"yt", "xy"})};
    for (auto part : {in_group("Wave 1", {}, generator_settings("1", "sine", 2)),
                      in_group("Wave 2", {}, generator_settings("2", "saw", 3)),
                      in_group("Both waves", {}, shared_settings()),
                      scope_settings({.yt_modes = {"yt"}, .scope_modes = {"yt", "xy"}})})
        settings.insert(settings.end(), part.begin(), part.end());
    return settings;
}
}  // namespace

SignalKind waveform_kind() {
    return {
        .kind = "waveform",
        .label = "Two-channel waveform",
        .help = "Two wave generators on a two-channel scope.",
        .settings = all_settings(),
        .make = [](const Settings& chosen, const SignalMedia&) -> Result<std::unique_ptr<Signal>> {
            return std::make_unique<Waveform>(chosen);
        }};
}
