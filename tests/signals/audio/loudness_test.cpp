#include "signals/audio/loudness.h"

#include "about.h"
#include "signals/signal_making.h"

namespace {
constexpr double attack = 0.05;
constexpr double release = 0.4;

/// 0.8 in the first second, then silence.
double step_peak(std::int64_t stretch) {
    return stretch < 100 ? 0.8 : 0.0;
}

/// Bursts of 60 Hz for 30 ms every half second, over quiet hum.
std::shared_ptr<const Sound> clicks() {
    constexpr int rate = 8000;
    const auto left = [](int i) {
        const double seconds = i / 8000.0;
        const bool is_click = std::fmod(seconds, 0.5) < 0.03;
        return 0.01 * sine_at(1000.0, seconds) + (is_click ? 0.8 * sine_at(60.0, seconds) : 0.0);
    };
    return sound_of(rate, 4 * rate, left, left);
}
}  // namespace

TEST_CASE("an envelope rises and falls with its time constants") {
    const Envelopes envelopes(step_peak);
    CHECK(envelopes.at(0.0, attack, release) == 0.0);
    for (const double t : {0.01, 0.05, 0.2, 0.99})
        CHECK(is_near(envelopes.at(t, attack, release), 0.8 * (1.0 - std::exp(-t / attack)), 1e-9));
    const double top = 0.8 * (1.0 - std::exp(-1.0 / attack));
    for (const double t : {1.01, 1.4, 1.99})
        CHECK(
            is_near(envelopes.at(t, attack, release), top * std::exp(-(t - 1.0) / release), 1e-9));
}

TEST_CASE("an envelope depends only on the time, not on earlier calls") {
    const auto hum = [](std::int64_t stretch) {
        return 0.5 + 0.5 * std::sin(static_cast<double>(stretch));
    };
    const Envelopes at_30(hum);
    const Envelopes at_144(hum);
    for (int frame = 1; frame <= 144 * 20; ++frame)
        (void)at_144.at(frame / 144.0, attack, release);
    for (int frame = 1; frame <= 30 * 20; ++frame) {
        const double seconds = frame / 30.0;
        const double level = at_30.at(seconds, attack, release);
        CHECK(Envelopes(hum).at(seconds, attack, release) == level);
        CHECK(at_144.at(seconds, attack, release) == level);
    }
    // It restarts each second, and still equals an envelope with unlimited memory.
    double whole = 0.0;
    for (int i = 0; i < 1999; ++i)
        whole += (hum(i) - whole) * (1.0 - std::exp(-0.01 / (hum(i) > whole ? attack : release)));
    CHECK(is_near(at_30.at(19.99, attack, release), whole, 1e-5));
}

TEST_CASE("the level of a sound is the peak of both channels, 1 for full scale") {
    const auto sound = sound_of(
        48000, 48000, [](int) { return 0.0; },
        [](int i) { return i < 24000 ? 0.5 * sine_at(1000.0, i / 48000.0) : 0.0; });
    const SoundLoudness loudness(stream_of(sound, {}));
    CHECK(is_near(loudness.envelope(0.5, 0.001, release), 0.5, 1e-4));
    CHECK(is_near(loudness.envelope(0.9, 0.001, release), 0.5 * std::exp(-1.0), 1e-4));
    const SoundLoudness later(stream_of(sound, {.first = 24000}));
    CHECK(later.envelope(0.5, 0.001, release) == 0.0);
}

TEST_CASE("the level of a beam is its distance from the centre, and it has no beats") {
    const BeamLoudness loudness(signal_of("lissajous:x=50,y=40,amplitude=0.6"));
    CHECK(is_near(loudness.envelope(1.0, 0.001, 1.0), 0.6, 0.002));
    CHECK_FALSE(loudness.seconds_since_beat(1.0, 1.0).has_value());
}

TEST_CASE("beats are reported as the time since the last one") {
    const SoundLoudness loudness(stream_of(clicks(), {}));
    for (const double seconds : {1.3, 1.9, 3.2}) {
        const auto since = loudness.seconds_since_beat(seconds, 2.0);
        REQUIRE(since.has_value());
        // A beat is detected 10 to 20 ms after the start of its burst.
        CHECK(*since < std::fmod(seconds, 0.5));
        CHECK(*since > std::fmod(seconds, 0.5) - 0.0201);
    }
    CHECK_FALSE(loudness.seconds_since_beat(3.9, 200.0).has_value());
}
