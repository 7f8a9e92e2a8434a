#include "signals/waveform.h"

#include "signals/points.h"
#include "signals/settings.h"
#include "signals/shape.h"

namespace {
struct Channel {
    Shape shape = Shape::off;
    double periods = 0.0;  // in 1/60 s
    double amplitude = 0.0;
    double phase = 0.0;  // turns
    std::uint64_t seed = 0;

    bool is_on() const { return shape != Shape::off; }
    double at(double turns) const { return amplitude * wave(shape, turns + phase, seed); }
};

Channel channel_of(const Settings& settings, const std::string& number) {
    return {.shape = shape_named(settings.word("ch" + number)),
            .periods = settings.number("f" + number),
            .amplitude = settings.number("a" + number),
            .phase = settings.number("p" + number),
            .seed = static_cast<std::uint64_t>(settings.whole("seed")) * 2 + (number == "2")};
}

class Waveform : public Signal {
public:
    explicit Waveform(const Settings& settings)
        : m_first(channel_of(settings, "1")),
          m_second(channel_of(settings, "2")),
          m_scroll(settings.number("speed") / 60.0),
          m_points(settings.whole("points")),
          m_charge(charge_of_point(static_cast<double>(m_points) * 60.0)),
          m_is_xy(settings.is("mode", "xy")) {}

    void trace(const TimeSpan& span, Beam& beam) const override {
        const PointStream stream{.rate = static_cast<double>(m_points) * 60.0};
        if (m_is_xy)
            trace_points(span, stream, beam, [this](std::int64_t k) { return across_and_up(k); });
        else if (m_first.is_on() || m_second.is_on())
            trace_points(span, stream, beam, [this](std::int64_t k) { return swept(k); });
    }

private:
    BeamPoint across_and_up(std::int64_t k) const {
        const double u = static_cast<double>(k + 1) / static_cast<double>(m_points);
        return {static_cast<float>(m_first.at((m_first.periods + m_scroll) * u)),
                static_cast<float>(m_second.at(m_second.periods * u)),
                static_cast<float>(m_charge)};
    }

    // With both channels on, the first half of each 1/60 s draws one and the second half the other.
    BeamPoint swept(std::int64_t k) const {
        const bool both = m_first.is_on() && m_second.is_on();
        const std::int64_t frame = k / m_points;
        const std::int64_t place = k % m_points;
        const std::int64_t half = m_points / 2;
        if (!both)
            return on_sweep(m_first.is_on() ? m_first : m_second, frame, place, m_points, {});
        if (place < half)
            return on_sweep(m_first, frame, place, half, {0.45, 0.5});
        return on_sweep(m_second, frame, place - half, m_points - half, {0.45, -0.5});
    }

    struct Band {
        double scale = 1.0;
        double center = 0.0;
    };

    // The trace stands still during a sweep; noise goes on from sweep to sweep.
    BeamPoint on_sweep(const Channel& channel, std::int64_t frame, std::int64_t place,
                       std::int64_t length, const Band& band) const {
        const SweepPoint point = sweep_point(place, length, m_charge);
        double turns = channel.periods * point.across + m_scroll * static_cast<double>(frame);
        if (channel.shape == Shape::noise)
            turns += channel.periods * static_cast<double>(frame);
        const double y = band.center + band.scale * channel.at(turns);
        return {point.x, static_cast<float>(y), point.intensity};
    }

    Channel m_first;
    Channel m_second;
    double m_scroll;  // turns per 1/60 s
    std::int64_t m_points;
    double m_charge;
    bool m_is_xy;
};

std::vector<SettingFacts> channel_settings(const std::string& number, const std::string& shape,
                                           double periods) {
    const std::string name = "Channel " + number;
    return {{.key = "ch" + number,
             .label = name,
             .help = "The shape of its wave.",
             .type = SettingType::word,
             .words = shape_names(),
             .initial_word = shape},
            {.key = "f" + number,
             .label = name + " periods",
             .unit = "per 1/60 s",
             .help = "Periods across the screen.",
             .low = 0.5,
             .high = 20,
             .initial = periods,
             .limit = {0, 10000}},
            {.key = "a" + number,
             .label = name + " amplitude",
             .help = "1 fills the channel's part of the screen.",
             .initial = 0.7,
             .limit = {0, 1}},
            {.key = "p" + number,
             .label = name + " phase",
             .unit = "turns",
             .help = "Where in its period the wave starts."}};
}
}  // namespace

SignalKind waveform_kind() {
    std::vector<SettingFacts> settings = channel_settings("1", "sine", 2);
    for (SettingFacts& setting : channel_settings("2", "saw", 3))
        settings.push_back(std::move(setting));
    settings.push_back({.key = "mode",
                        .label = "Shown as",
                        .help =
                            "yt: traces over time, the channels one above the other. xy: channel 1 "
                            "across, channel 2 up.",
                        .type = SettingType::word,
                        .words = {"yt", "xy"},
                        .initial_word = "yt"});
    settings.push_back({.key = "speed",
                        .label = "Scroll",
                        .unit = "periods/s",
                        .help = "How fast the traces move to the left; in xy channel 1 against 2.",
                        .low = -2,
                        .high = 2,
                        .limit = {-1000, 1000}});
    settings.push_back({.key = "seed",
                        .label = "Noise seed",
                        .help = "Another number, another noise.",
                        .low = 1,
                        .high = 100,
                        .step = 1,
                        .initial = 1,
                        .limit = {0, 1e6}});
    settings.push_back(points_setting());
    return {
        .kind = "waveform",
        .label = "Two-channel waveform",
        .help = "Two wave generators on a two-channel scope. A sweep takes 1/60 s.",
        .settings = std::move(settings),
        .make = [](const Settings& chosen, const SignalMedia&) -> Result<std::unique_ptr<Signal>> {
            return std::make_unique<Waveform>(chosen);
        }};
}
