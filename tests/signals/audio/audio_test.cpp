#include "signals/audio/audio.h"

#include "about.h"
#include "signals/signal_making.h"

#include <algorithm>

namespace {
float widest(const Beam& beam) {
    float highest = 0.0f;
    for (const BeamPoint& point : beam)
        highest = std::max({highest, std::abs(point.x), std::abs(point.y)});
    return highest;
}
}  // namespace

TEST_CASE("xy: left is x, right is y, and a frame has the samples of its time span") {
    const auto sound = sound_of(
        48000, 48000, [](int i) { return i * 1e-5; }, [](int i) { return -0.5 + i * 1e-5; });
    const Beam beam = beam_of(*signal_of("audio:a.wav,upsample=1", sound), frame_span(31, 60.0));
    REQUIRE(beam.size() == 800);
    CHECK(beam.front().x == sound->samples[48000]);
    CHECK(beam.back().y == sound->samples[49599]);
    CHECK(std::abs(beam.back().age_seconds) < 1e-6);
}

TEST_CASE("xy: a constant level is kept, and mono draws the diagonal") {
    auto mono = std::make_shared<Sound>(Sound{48000, 1, std::vector<float>(4800, 0.4f)});
    for (const BeamPoint& point : beam_of(*signal_of("audio:a.wav", mono), frame_span(2, 60.0))) {
        REQUIRE(point.x == about(0.4, 1e-6));
        REQUIRE(point.y == point.x);
    }
}

TEST_CASE("the level multiplies the deflection") {
    const auto sound = circle(48000, 4800, 1000.0);
    const Beam plain = beam_of(*signal_of("audio:a.wav", sound), frame_span(3, 60.0));
    const Beam halved = beam_of(*signal_of("audio:a.wav,level=0.5", sound), frame_span(3, 60.0));
    REQUIRE(plain.size() == halved.size());
    for (std::size_t i = 0; i < plain.size(); ++i)
        REQUIRE(halved[i].x == doctest::Approx(plain[i].x * 0.5));
}

TEST_CASE("a sound without loop ends, and each of its samples is drawn once") {
    const auto signal = signal_of("audio:a.wav,loop=off,upsample=3", circle(44100, 10000, 500.0));
    CHECK(signal->seconds() == doctest::Approx(10000.0 / 44100.0));
    std::size_t points = 0;
    for (std::int64_t n = 1; n <= 60; ++n)
        points += beam_of(*signal, frame_span(n, 60.0)).size();
    CHECK(points == 30000);
    const Beam last = beam_of(*signal, {0.2, 1.0});
    CHECK(last.back().age_seconds == doctest::Approx(1.0 - 10000.0 / 44100.0));
    CHECK(std::isinf(signal_of("audio:a.wav", circle(44100, 100, 500.0))->seconds()));
}

TEST_CASE("the path of a loop continues from its end to its start") {
    const auto signal = signal_of("audio:a.wav", circle(48000, 240, 1000.0));
    const Beam beam = beam_of(*signal, {0.0, 1.0});
    REQUIRE(beam.size() == 192000);
    for (const BeamPoint& point : beam)
        REQUIRE(std::hypot(point.x, point.y) == about(0.5, 1e-3));
}

TEST_CASE("time 0 and the loop start at `start`") {
    const auto sound = sound_of(
        1000, 1000, [](int i) { return i * 1e-3; }, [](int) { return 0.0; });
    const auto signal = signal_of("audio:a.wav,start=0.6,upsample=1", sound);
    CHECK(beam_of(*signal, {0.0, 0.001}).front().x == doctest::Approx(0.6));
    CHECK(beam_of(*signal, {0.4, 0.401}).front().x == doctest::Approx(0.6));
    CHECK(beam_of(*signal, {0.399, 0.4}).front().x == doctest::Approx(0.999));
}

TEST_CASE("automatic gain scales the peak of the last second to full scale, by at most 40 dB") {
    const auto loudness = [](double factor) {
        return sound_of(
            8000, 32000, [=](int i) { return factor * sine_at(440.0, i / 8000.0); },
            [](int) { return 0.0; });
    };
    const auto quiet = signal_of("audio:a.wav,auto_gain=on", loudness(0.1));
    CHECK(widest(beam_of(*quiet, {1.0, 3.0})) == about(1.0, 0.01));
    const auto hushed = signal_of("audio:a.wav,auto_gain=on", loudness(0.001));
    CHECK(widest(beam_of(*hushed, {1.0, 3.0})) == about(0.1, 0.01));
}

TEST_CASE("automatic gain fits a burst from its first sample, and recovers after a second") {
    const auto sound = sound_of(
        8000, 40000, [](int i) { return (i / 8000 == 1 ? 0.8 : 0.1) * sine_at(440.0, i / 8000.0); },
        [](int) { return 0.0; });
    const auto signal = signal_of("audio:a.wav,auto_gain=on,upsample=1", sound);
    CHECK(widest(beam_of(*signal, {0.0, 5.0})) <= 1.0001f);
    CHECK(widest(beam_of(*signal, {1.0, 2.0})) == about(1.0, 0.01));
    CHECK(widest(beam_of(*signal, {2.2, 2.8})) == about(0.125, 0.02));
    CHECK(widest(beam_of(*signal, {3.5, 4.5})) == about(1.0, 0.01));
}

TEST_CASE("automatic gain is linear between tenths of a second") {
    // The level is 0.8 from 1.0 s on; the gain falls during the tenth before it.
    const auto sound = sound_of(
        8000, 16000, [](int i) { return i < 8000 ? 0.1 : 0.8; }, [](int) { return 0.0; });
    const auto signal = signal_of("audio:a.wav,auto_gain=on,upsample=1,loop=off", sound);
    for (const double share : {0.25, 0.5, 0.75}) {
        CAPTURE(share);
        const double place = 0.9 + 0.1 * share;
        const double gain = (1.0 - share) / 0.1 + share / 0.8;
        const Beam beam = beam_of(*signal, {place - 0.0002, place + 0.0002});
        REQUIRE_FALSE(beam.empty());
        CHECK(widest(beam) == about(0.1 * gain, 0.01));
    }
}

TEST_CASE("automatic gain looks across the end of a sound only in a loop") {
    const auto sound = sound_of(
        8000, 24000, [](int i) { return i < 16000 ? 0.1 : 0.8; }, [](int) { return 0.0; });
    const auto once = signal_of("audio:a.wav,auto_gain=on,upsample=1,loop=off", sound);
    CHECK(widest(beam_of(*once, {0.0, 0.5})) == about(1.0, 0.001));
    const auto looped = signal_of("audio:a.wav,auto_gain=on,upsample=1,loop=on", sound);
    CHECK(widest(beam_of(*looped, {0.0, 0.5})) == about(0.125, 0.001));
}

TEST_CASE("waveform: x is time, and y is the mean of both channels") {
    const auto sound = sound_of(
        8000, 8000, [](int) { return 0.2; }, [](int) { return 0.6; });
    const Beam beam =
        beam_of(*signal_of("audio:a.wav,mode=waveform,trigger=off,sdiv=0.01,upsample=1", sound),
                {0.0, 0.1});
    REQUIRE(beam.size() == 800);
    CHECK(beam[199].x == doctest::Approx(-0.5));
    CHECK(beam[799].x == 1.0f);
    CHECK(beam[400].y == doctest::Approx(0.4));
    const auto right = signal_of("audio:a.wav,mode=waveform,trigger=off,channel=right", sound);
    CHECK(beam_of(*right, {0.1, 0.2})[100].y == doctest::Approx(0.6));
}

TEST_CASE("a rising trigger starts every sweep at the same phase") {
    constexpr double hertz = 130.3;
    const auto sound = sound_of(
        48000, 96000, [](int i) { return 0.9 * sine_at(hertz, i / 48000.0 + 0.002); },
        [](int) { return 0.0; });
    const Beam beam = beam_of(
        *signal_of("audio:a.wav,mode=waveform,trigger=auto,channel=left", sound), {0.0, 1.9});
    const double step = 0.9 * 2.0 * std::numbers::pi * hertz / (48000.0 * 4.0);
    int sweeps = 0;
    for (std::size_t i = 1; i < beam.size(); ++i) {
        if (beam[i].intensity == 0.0f || beam[i - 1].intensity != 0.0f)
            continue;
        ++sweeps;  // the second point of a sweep, at most two steps above 0
        REQUIRE(beam[i].y > 0.0f);
        REQUIRE(beam[i].y < 2.1 * step);
    }
    // 0.02 s have 2.6 periods: each sweep starts three periods after the previous one.
    CHECK(sweeps == about(1.9 * hertz / 3.0, 0.02));
}

TEST_CASE("a sound that never crosses 0 sweeps without a trigger") {
    const auto sound = sound_of(
        8000, 8000, [](int) { return 0.5; }, [](int) { return 0.5; });
    const Beam beam =
        beam_of(*signal_of("audio:a.wav,mode=waveform,trigger=auto", sound), {0.0, 1.0});
    const auto dark = std::count_if(beam.begin(), beam.end(),
                                    [](const BeamPoint& point) { return point.intensity == 0.0f; });
    CHECK(dark == 50);  // retraces
}

TEST_CASE("without a crossing, free-running sweeps start 0.1 s after the last one") {
    // The last rising crossing is at 0.405 s; a sweep takes 0.02 s.
    const auto sound = sound_of(
        8000, 8000, [](int i) { return i < 3600 ? sine_at(10.0, (i - 40) / 8000.0) : -0.2; },
        [](int) { return 0.0; });
    const auto signal =
        signal_of("audio:a.wav,mode=waveform,trigger=auto,channel=left,sdiv=0.002,loop=off", sound);
    const auto light_in = [&signal](double start, double end) {
        double light = 0.0;
        for (const BeamPoint& point : beam_of(*signal, {start, end}))
            light += static_cast<double>(point.intensity);
        return light;
    };
    CHECK(light_in(0.406, 0.424) > 0.0);
    CHECK(light_in(0.427, 0.503) == 0.0);
    CHECK(light_in(0.506, 0.7) > 0.0);
    CHECK(light_in(0.506, 0.524) > 0.0);
}

TEST_CASE("a missing, empty or too short sound is an error") {
    const Spec spec = parse_spec("audio:a.wav").value();
    CHECK_FALSE(make_signal(spec, {}).has_value());
    CHECK_FALSE(make_signal(spec, {std::make_shared<Sound>()}).has_value());
    CHECK_FALSE(make_signal(spec, {std::make_shared<Sound>(Sound{0, 1, {0.0f}})}).has_value());
    const auto late = make_signal(parse_spec("audio:a.wav,start=5").value(),
                                  {std::make_shared<Sound>(Sound{10, 1, std::vector<float>(20)})});
    REQUIRE_FALSE(late.has_value());
    CHECK(to_string(late.error()) ==
          "error: audio: 'start' is 5 s, but the sound is only 2 s long\n");
}

TEST_CASE("a sound plays from its start to its end, and loops there") {
    auto sound = std::make_shared<Sound>(Sound{1000, 1, {}});
    for (int i = 0; i < 1000; ++i)
        sound->samples.push_back(static_cast<float>(i) / 1000.0f);
    const auto signal = signal_of("audio:a.wav,start=0.2,end=0.5,upsample=1", sound);
    const Beam beam = beam_of(*signal, {0.0, 0.6});
    REQUIRE(beam.size() == 600);
    for (std::size_t i = 0; i < beam.size(); ++i)
        REQUIRE(beam[i].x == sound->samples[200 + i % 300]);
    const auto once = signal_of("audio:a.wav,start=0.2,end=0.5,upsample=1,loop=off", sound);
    CHECK(once->seconds() == doctest::Approx(0.3));
    CHECK(beam_of(*once, {0.0, 0.6}).size() == 300);
}

TEST_CASE("an end that is not after the start is refused") {
    const auto made = make_signal(parse_spec("audio:a.wav,start=0.5,end=0.5").value(),
                                  {.sound = circle(48000, 48000, 100.0)});
    REQUIRE_FALSE(made.has_value());
    CHECK(made.error().front().message ==
          "audio: 'end' is 0.5 s, but 'start' is 0.5 s. Use a later end, or 0 for the end of the "
          "sound.");
}
