// Signals of sines: docs/signals.md, "Generators".
#include "portable_player/error.h"
#include "portable_player/signal.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace {
constexpr double turn = 2.0 * std::numbers::pi;

using Wave = std::function<double(double u)>;  // u in 1/60 s

class Lissajous : public Signal {
public:
    explicit Lissajous(const Json& settings)
        : m_x(settings.at("x").get<double>() + settings.at("speed").get<double>() / 60.0),
          m_y(settings.at("y")),
          m_phase(settings.at("phase")),
          m_amplitude(settings.at("amplitude")),
          m_rate(settings.at("points").get<double>() * 60.0),
          m_is_weighted(settings.at("weighting") == "speed") {}

    void trace(double start, double end, std::vector<BeamPoint>& points) const override {
        const Instants instants = instants_in(start, end, m_rate);
        for (long k = instants.first; k < instants.end; ++k) {
            const double time = static_cast<double>(k + 1) / m_rate;
            const double across = turn * (m_x * 60.0 * time + m_phase);
            const double up = turn * m_y * 60.0 * time;
            const double current = m_is_weighted ? current_at(across, up) : 1.0;
            points.push_back({time, m_amplitude * std::sin(across), m_amplitude * std::sin(up),
                              current * full_charge_rate / m_rate});
        }
    }

private:
    double current_at(double across, double up) const {
        const double fastest = std::hypot(m_x, m_y);
        const double speed = std::hypot(m_x * std::cos(across), m_y * std::cos(up));
        return 0.3 + 0.7 * 0.05 / ((fastest > 0.0 ? speed / fastest : 0.0) + 0.05);
    }

    double m_x;
    double m_y;
    double m_phase;
    double m_amplitude;
    double m_rate;
    bool m_is_weighted;
};

/// One wave over time, or against itself a quarter of a period earlier.
class OneWave : public Signal {
public:
    OneWave(const Json& settings, Wave wave, double periods)
        : m_wave(std::move(wave)),
          m_quarter(0.25 / periods),
          m_amplitude(settings.at("amplitude")),
          m_speed(settings.at("speed").get<double>() / 60.0),
          m_points(settings.at("points")),
          m_is_xy(settings.at("mode") == "xy") {}

    void trace(double start, double end, std::vector<BeamPoint>& points) const override {
        const double rate = 60.0 * static_cast<double>(m_points);
        const Instants instants = instants_in(start, end, rate);
        for (long k = instants.first; k < instants.end; ++k) {
            BeamPoint point = m_is_xy ? against_itself(k) : on_sweep(k);
            point.time = static_cast<double>(k + 1) / rate;
            points.push_back(point);
        }
    }

private:
    double charge() const { return 4096.0 / static_cast<double>(m_points); }

    BeamPoint against_itself(long k) const {
        const double u = static_cast<double>(k + 1) / static_cast<double>(m_points);
        return {0.0, m_amplitude * m_wave(u), m_amplitude * m_wave(u - m_quarter), charge()};
    }

    // The move to the first point is blanked. The other points share its light.
    BeamPoint on_sweep(long k) const {
        const auto count = static_cast<double>(m_points);
        const double across = static_cast<double>(k % m_points + 1) / count;
        const long sweep = k / m_points;
        const double scrolled = m_speed * static_cast<double>(sweep);
        const bool is_first = k % m_points == 0;
        return {0.0, 2.0 * across - 1.0, m_amplitude * m_wave(across + scrolled),
                is_first ? 0.0 : charge() * count / (count - 1.0)};
    }

    Wave m_wave;
    double m_quarter;  // of the period
    double m_amplitude;
    double m_speed;  // sweeps per sweep
    long m_points;
    bool m_is_xy;
};

double strength(const std::string& shape, int n, double falloff) {
    if (shape != "saw" && n % 2 == 0)
        return 0.0;
    const double size = std::pow(n, -falloff);
    return shape == "triangle" && n % 4 == 3 ? -size : size;
}

// The sum of sines, divided by its largest value in a period.
Wave harmonics_wave(const Json& settings) {
    constexpr int samples = 32768;
    std::vector<double> strengths;
    for (int n = 1; n <= settings.at("count").get<int>(); ++n)
        strengths.push_back(strength(settings.at("shape"), n, settings.at("falloff")));
    const double base = settings.at("base");
    const auto sum = [strengths](double turns) {
        double value = 0.0;
        for (std::size_t i = 0; i < strengths.size(); ++i)
            value += strengths[i] * std::sin(turn * static_cast<double>(i + 1) * turns);
        return value;
    };
    double peak = 0.0;
    for (int i = 0; i < samples; ++i)
        peak = std::max(peak, std::abs(sum(static_cast<double>(i) / samples)));
    return [sum, base, peak](double u) { return sum(base * u) / peak; };
}
}  // namespace

Instants instants_in(double start, double end, double rate) {
    constexpr double rounding = 1e-6;
    const auto until = [rate](double time) {
        return static_cast<long>(std::floor(std::max(time, 0.0) * rate + rounding));
    };
    return {until(start), until(end)};
}

std::unique_ptr<Signal> make_lissajous(const Json& settings) {
    return std::make_unique<Lissajous>(settings);
}

std::unique_ptr<Signal> make_harmonics(const Json& settings) {
    return std::make_unique<OneWave>(settings, harmonics_wave(settings), settings.at("base"));
}

std::unique_ptr<Signal> make_am(const Json& settings) {
    const double carrier = settings.at("carrier");
    const double modulator = settings.at("modulator");
    const double depth = settings.at("depth");
    return std::make_unique<OneWave>(
        settings,
        [=](double u) {
            return (1.0 + depth * std::sin(turn * modulator * u)) / (1.0 + depth) *
                   std::sin(turn * carrier * u);
        },
        carrier);
}

std::unique_ptr<Signal> make_fm(const Json& settings) {
    const double carrier = settings.at("carrier");
    const double modulator = settings.at("modulator");
    const double index = settings.at("index");
    return std::make_unique<OneWave>(
        settings,
        [=](double u) {
            return std::sin(turn * carrier * u + index * std::sin(turn * modulator * u));
        },
        carrier);
}

std::unique_ptr<Signal> make_signal(const Json& signal) {
    const std::string kind = signal.at("kind");
    const Json& settings = signal.at("settings");
    if (kind == "lissajous")
        return make_lissajous(settings);
    if (kind == "harmonics")
        return make_harmonics(settings);
    if (kind == "am")
        return make_am(settings);
    if (kind == "fm")
        return make_fm(settings);
    if (kind == "waveform")
        return make_waveform(settings);
    const bool is_scene = kind == "text" || kind == "scene";
    if (!is_scene && kind != "drawing")
        throw Error("has the signal '" + kind + "', which this player doesn't support");
    const double rate = settings.at("points").get<double>() * 60.0;
    const Json& paths = signal.at("paths");
    return is_scene ? make_scene(paths, rate) : make_drawing(paths, rate);
}
