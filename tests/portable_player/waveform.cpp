// Two waves on an oscilloscope: docs/signals.md, "waveform" and "Oscilloscope".
#include "portable_player/signal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

namespace {
double part(double turns) {
    return turns - std::floor(turns);
}

// SplitMix64 of a number, from -1 to 1.
double random_level(std::int64_t index, std::uint64_t seed) {
    std::uint64_t bits = static_cast<std::uint64_t>(index) + seed * 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    bits ^= bits >> 31U;
    return static_cast<double>(bits >> 11U) * 0x1p-52 - 1.0;
}

/// A wave generator with the channel that it is connected to.
struct Channel {
    std::string shape;
    double hertz = 0.0;
    double amplitude = 0.0;
    double phase = 0.0;
    double offset_volts = 0.0;
    std::uint64_t seed = 0;
    double volts = 0.25;  // per division
    double position = 0.0;
    std::string coupling;
    bool is_inverted = false;

    bool is_on() const { return shape != "off"; }
    double mean() const { return coupling == "dc" ? offset_volts : 0.0; }

    // From -1 to 1.
    double wave(double turns) const {
        if (shape == "sine")
            return std::sin(2.0 * std::numbers::pi * turns);
        if (shape == "triangle")
            return 1.0 - 4.0 * std::abs(part(turns + 0.25) - 0.5);
        if (shape == "square")
            return part(turns) < 0.5 ? 1.0 : -1.0;
        if (shape == "saw")
            return 2.0 * part(turns + 0.5) - 1.0;
        const double below = std::floor(32.0 * turns);
        const auto index = static_cast<std::int64_t>(below);
        return std::lerp(random_level(index, seed), random_level(index + 1, seed),
                         32.0 * turns - below);
    }

    double volts_at(double seconds, double scrolled) const {
        if (!is_on() || coupling == "gnd")
            return 0.0;
        return mean() + amplitude * wave(hertz * seconds + phase + scrolled);
    }

    // On a screen whose half height is four divisions.
    double deflection(double input) const {
        return (position + (is_inverted ? -input : input) / volts) / 4.0;
    }
};

std::array<Channel, 2> channels_of(const Json& settings) {
    std::array<Channel, 2> channels;
    const double unit = settings.at("per") == "second" ? 1.0 : 60.0;
    const bool is_swapped = settings.at("swap") == "on";
    for (std::size_t i = 0; i < 2; ++i) {
        const auto of_wave = [&](const char* key) -> const Json& {
            return settings.at(key + std::to_string(is_swapped ? 2 - i : i + 1));
        };
        const auto own = [&](const char* key) -> const Json& {
            return settings.at(key + std::to_string(i + 1));
        };
        const std::uint64_t is_second = is_swapped ? 1 - i : i;
        channels[i] = {.shape = of_wave("ch"),
                       .hertz = of_wave("f").get<double>() * unit,
                       .amplitude = of_wave("a"),
                       .phase = of_wave("p"),
                       .offset_volts = of_wave("d"),
                       .seed = 2 * settings.at("seed").get<std::uint64_t>() + is_second,
                       .volts = own("v"),
                       .position = own("o"),
                       .coupling = own("coupling"),
                       .is_inverted = own("invert") == "on"};
    }
    return channels;
}

// The phase in turns at which a wave crosses a level; nothing if it does not.
std::optional<double> crossing(const std::string& shape, double level, bool is_rising) {
    if (shape == "off" || std::abs(level) >= 1.0)
        return std::nullopt;
    if (shape == "sine") {
        const double turns = std::asin(level) / (2.0 * std::numbers::pi);
        return is_rising ? turns : 0.5 - turns;
    }
    if (shape == "triangle")
        return is_rising ? 0.25 * level : 0.5 - 0.25 * level;
    if (shape == "square")
        return is_rising ? 0.0 : 0.5;
    return is_rising ? 0.5 * level : 0.5;
}

// The first time from 0 on at which a channel starts a sweep.
std::optional<double> first_trigger(const Channel& channel, double level, bool is_rising) {
    if (channel.coupling == "gnd" || channel.amplitude <= 0.0 || channel.hertz <= 0.0)
        return std::nullopt;
    if (channel.shape == "noise")
        return 0.0;
    const double volts = channel.is_inverted ? -level : level;
    const auto turns = crossing(channel.shape, (volts - channel.mean()) / channel.amplitude,
                                is_rising != channel.is_inverted);
    if (!turns)
        return std::nullopt;
    return part(*turns - channel.phase) / channel.hertz;
}

/// When sweeps start, in samples.
struct Sweeps {
    double first = 0.0;
    double period = 0.0;  // 0: there is one sweep
    double length = 0.0;
    bool exist = true;
};

Sweeps sweeps_of(const Json& settings, const std::array<Channel, 2>& channels, double rate) {
    const double sweep = 10.0 * settings.at("sdiv").get<double>();
    const double busy = sweep + settings.at("holdoff").get<double>();
    const std::string mode = settings.at("trigger");
    const std::string source = settings.at("trigger_source");
    if (mode == "off")
        return {0.0, sweep * rate, sweep * rate};
    const std::size_t shown = channels[0].is_on() ? 0 : 1;
    const Channel& watched = channels[source == "shown" ? shown : source == "1" ? 0 : 1];
    const auto first =
        first_trigger(watched, settings.at("trigger_level"), settings.at("slope") == "rising");
    if (!first)
        return {0.0, busy * rate, sweep * rate, mode == "auto"};
    double period = busy;
    if (watched.shape != "noise")
        period = std::ceil(busy * watched.hertz - 1e-6) / watched.hertz;
    return {*first * rate, mode == "single" ? 0.0 : period * rate, sweep * rate};
}

constexpr double rounding = 1e-3;  // samples

/// The samples of one sweep.
struct Sweep {
    double start = 0.0;
    long first = 0;
    long count = 0;
};

std::optional<Sweep> sweep_at(long sample, const Sweeps& sweeps) {
    const double after = static_cast<double>(sample + 1) - rounding - sweeps.first;
    if (!sweeps.exist || after <= 0.0)
        return std::nullopt;
    const double number = sweeps.period > 0.0 ? std::ceil(after / sweeps.period) - 1.0 : 0.0;
    const double start = sweeps.first + number * sweeps.period;
    const auto first = static_cast<long>(std::floor(start + rounding));
    const auto end = static_cast<long>(std::floor(start + sweeps.length + rounding));
    if (sample >= end)
        return std::nullopt;
    return Sweep{start, first, end - first};
}

class Waveform : public Signal {
public:
    explicit Waveform(const Json& settings)
        : m_channels(channels_of(settings)),
          m_is_xy(settings.at("mode") == "xy"),
          m_is_split(settings.at("layout") == "split"),
          m_speed(settings.at("speed")),
          m_rate(settings.at("points").get<double>() * 60.0 / traces()),
          m_charge(full_charge_rate / m_rate / traces()),
          m_sweeps(sweeps_of(settings, m_channels, m_rate)) {}

    void trace(double start, double end, std::vector<BeamPoint>& points) const override {
        if (!m_is_xy && !m_channels[0].is_on() && !m_channels[1].is_on())
            return;
        const double rate = m_rate * traces();
        const Instants instants = instants_in(start, end, rate);
        for (long k = instants.first; k < instants.end; ++k) {
            BeamPoint point = m_is_xy ? xy_point(k) : sweep_point(k);
            point.time = static_cast<double>(k + 1) / rate;
            points.push_back(point);
        }
    }

private:
    bool has_two_traces() const {
        return !m_is_xy && m_channels[0].is_on() && m_channels[1].is_on();
    }
    double traces() const { return has_two_traces() ? 2.0 : 1.0; }

    BeamPoint xy_point(long k) const {
        const double seconds = static_cast<double>(k + 1) / m_rate;
        const double x = m_channels[0].volts_at(seconds, m_speed * seconds);
        return {0.0, m_channels[0].deflection(x),
                m_channels[1].deflection(m_channels[1].volts_at(seconds, 0.0)), m_charge};
    }

    BeamPoint sweep_point(long k) const {
        const long sample = has_two_traces() ? k / 2 : k;
        const auto sweep = sweep_at(sample, m_sweeps);
        if (!sweep)
            return {0.0, -1.0, 0.0, 0.0};
        if (!has_two_traces())
            return drawn(*sweep, m_channels[0].is_on() ? 0 : 1, sample,
                         {sample == sweep->first, sweep->count});
        // The channels alternate. Each draws a stretch of at most 1/60 s at twice the speed.
        const double turns = std::max(std::ceil(m_sweeps.length * 60.0 / m_rate - 1e-6), 1.0);
        const auto whole = static_cast<long>(std::ceil(static_cast<double>(sweep->count) / turns));
        const long index = k - 2 * sweep->first;
        const long begin = index / (2 * whole) * whole;
        const long length = std::min(whole, sweep->count - begin);
        const long along = (index - 2 * begin) % length;
        const std::size_t channel = index - 2 * begin < length ? 0 : 1;
        return drawn(*sweep, channel, sweep->first + begin + along, {along == 0, length});
    }

    /// A part of a trace that is drawn without a gap.
    struct Stretch {
        bool is_first_point = false;
        long count = 0;
    };

    BeamPoint drawn(const Sweep& sweep, std::size_t channel, long sample, Stretch stretch) const {
        const double seconds = static_cast<double>(sample + 1) / m_rate;
        const Channel& drawn = m_channels[channel];
        const double volts = drawn.volts_at(seconds, m_speed * sweep.start / m_rate);
        double y = drawn.deflection(volts);
        if (m_is_split && has_two_traces())
            y = 0.5 * y + (channel == 0 ? 0.5 : -0.5);
        const double across = (static_cast<double>(sample + 1) - sweep.start) / m_sweeps.length;
        const auto count = static_cast<double>(stretch.count);
        const double light = stretch.is_first_point ? 0.0 : m_charge * count / (count - 1.0);
        return {0.0, std::min(2.0 * across - 1.0, 1.0), y, light};
    }

    std::array<Channel, 2> m_channels;
    bool m_is_xy;
    bool m_is_split;
    double m_speed;
    double m_rate;  // samples per second
    double m_charge;
    Sweeps m_sweeps;
};
}  // namespace

std::unique_ptr<Signal> make_waveform(const Json& settings) {
    return std::make_unique<Waveform>(settings);
}
