#include "signals/scope/scope.h"

#include "signals/signal_making.h"

#include <algorithm>

namespace {
constexpr double pixel_width = 2.0 / 1280.0;  // of a picture as wide as the signal's -1..1

/// The positions where a trace rises through 0, linearly interpolated.
std::vector<double> rising_positions(const Beam& beam) {
    std::vector<double> places;
    for (std::size_t i = 1; i < beam.size(); ++i) {
        const BeamPoint& from = beam[i - 1];
        const BeamPoint& to = beam[i];
        if (to.intensity > 0.0f && to.x > from.x && from.y < 0.0f && to.y >= 0.0f)
            places.push_back(std::lerp(from.x, to.x, -from.y / (to.y - from.y)));
    }
    return places;
}

/// The start times of the sweeps, in seconds, of a beam that ends at age 0.
std::vector<double> sweep_times(const Beam& beam, double seconds) {
    std::vector<double> times;
    for (std::size_t i = 1; i < beam.size(); ++i)
        if (beam[i].intensity > 0.0f && beam[i - 1].intensity == 0.0f)
            times.push_back(seconds - beam[i - 1].age_seconds);
    return times;
}

double highest(const Beam& beam) {
    return std::max_element(beam.begin(), beam.end(),
                            [](const BeamPoint& a, const BeamPoint& b) { return a.y < b.y; })
        ->y;
}

std::shared_ptr<const Sound> tone(double hertz, double amplitude, double mean = 0.0) {
    return sound_of(
        48000, 96000, [=](int i) { return mean + amplitude * sine_at(hertz, i / 48000.0 + 1e-4); },
        [=](int i) { return 0.5 * sine_at(2.0 * hertz, i / 48000.0); });
}

/// The largest deflection from 1 s to 2 s, after couplings have settled.
double amplitude_of(const std::string& text, const std::shared_ptr<const Sound>& sound) {
    return highest(beam_of(*signal_of(text, sound), {1.0, 2.0}));
}
}  // namespace

TEST_CASE("a 1 kHz sine at 1 ms/div has one period per division") {
    const auto generator = signal_of("waveform:ch2=off,ch1=sine,f1=1000,per=second,sdiv=0.001");
    const auto sound =
        signal_of("audio:a.wav,mode=waveform,channel=left,sdiv=0.001", tone(1000.0, 0.5));
    for (const Signal* signal : {generator.get(), sound.get()}) {
        const auto places = rising_positions(beam_of(*signal, {0.1, 0.5}));
        REQUIRE(places.size() > 9 * 30);
        for (const double place : places) {
            const double division = (place + 1.0) / 0.2;
            REQUIRE(std::abs(division - std::round(division)) * 0.2 < pixel_width);
        }
    }
}

TEST_CASE("a vertical division is a quarter of half the height, scaled by V/div") {
    const auto at = [](const std::string& settings) {
        return highest(beam_of(*signal_of("waveform:ch2=off,f1=2,a1=1," + settings), {0.0, 0.1}));
    };
    CHECK(at("v1=0.25") == doctest::Approx(1.0));
    CHECK(at("v1=0.5") == doctest::Approx(0.5));
    CHECK(at("v1=1,o1=1.5") == doctest::Approx(0.25 + 1.5 * 0.25));
    CHECK(at("v1=1,d1=2") == doctest::Approx(0.75));
    CHECK(at("v1=1,d1=2,coupling1=ac") == doctest::Approx(0.25));
    CHECK(at("v1=1,d1=2,coupling1=gnd") == 0.0);
    CHECK(at("v1=1,d1=2,invert1=on") == doctest::Approx(-0.25));
}

TEST_CASE("channel 2 has its own settings, and is vertical in xy") {
    const auto at = [](const std::string& settings) {
        return highest(
            beam_of(*signal_of("waveform:ch1=off,ch2=sine,f2=2,a2=1," + settings), {0.0, 0.1}));
    };
    CHECK(at("v1=5,v2=0.5") == doctest::Approx(0.5));
    CHECK(at("v2=1,o1=3,o2=-1.5") == doctest::Approx(0.25 - 1.5 * 0.25));
    CHECK(at("v2=1,d2=2,coupling2=ac") == doctest::Approx(0.25));
    CHECK(at("v2=1,d2=2,coupling2=gnd,coupling1=ac") == 0.0);
    CHECK(at("v2=1,d2=2,invert2=on,invert1=off") == doctest::Approx(-0.25));
    const Beam xy = beam_of(
        *signal_of("waveform:mode=xy,ch1=sine,a1=0,ch2=sine,a2=0,d1=1,d2=1,v1=1,v2=0.5,o1=1"),
        {0.0, 0.01});
    CHECK(xy.front().x == doctest::Approx(0.25 + 0.25));
    CHECK(xy.front().y == doctest::Approx(0.5));
}

TEST_CASE("split traces use half of the screen each, and overlaid traces all of it") {
    const std::string waves = "waveform:ch1=square,a1=1,ch2=square,a2=0.5,layout=";
    const Beam split = beam_of(*signal_of(waves + "split"), frame_span(1, 60.0));
    const Beam overlaid = beam_of(*signal_of(waves + "overlaid"), frame_span(1, 60.0));
    CHECK(split[5].y == doctest::Approx(1.0));
    CHECK(split[2048 + 5].y == doctest::Approx(-0.5 + 0.25));
    CHECK(overlaid[5].y == doctest::Approx(1.0));
    CHECK(overlaid[2048 + 5].y == doctest::Approx(0.5));
}

TEST_CASE("two traces have the same brightness at any time base") {
    const auto sound = tone(441.0, 0.5);
    for (const std::string time_base : {"0.0005", "0.002", "0.0123", "0.1"}) {
        INFO(time_base);
        const auto signal = signal_of(
            "audio:a.wav,mode=waveform,channel=both,trigger=off,v2=1000,o2=0,sdiv=" + time_base,
            sound);
        double first = 0.0;
        double second = 0.0;
        for (const BeamPoint& point : beam_of(*signal, {0.0, 2.0}))
            (std::abs(point.y + 0.5f) < 0.001f ? second : first) += point.intensity;
        CHECK(first == doctest::Approx(second).epsilon(0.01));
        CHECK(first + second == doctest::Approx(2.0 * 4096.0 * 60.0).epsilon(0.01));
    }
}

TEST_CASE("ac coupling attenuates 5 Hz by 3 dB, passes 100 Hz, and blocks 0 Hz") {
    const std::string xy = "audio:a.wav,upsample=1,coupling1=ac,swap=on,coupling2=ac";
    CHECK(amplitude_of(xy, tone(5.0, 0.8)) ==
          doctest::Approx(0.8 / std::numbers::sqrt2).epsilon(0.005));
    CHECK(amplitude_of(xy, tone(100.0, 0.8)) == doctest::Approx(0.8).epsilon(0.005));
    CHECK(amplitude_of(xy, tone(100.0, 0.4, 0.5)) == doctest::Approx(0.4).epsilon(0.01));
    CHECK(amplitude_of("audio:a.wav,swap=on", tone(100.0, 0.4, 0.5)) ==
          doctest::Approx(0.9).epsilon(0.005));
}

TEST_CASE("a sweep starts at the trigger level and slope, with sub-sample jitter") {
    constexpr double hertz = 130.3;
    const auto sound = tone(hertz, 0.8);
    struct Case {
        std::string settings;
        double turns;  // of the left wave at the trigger
    };
    const double at_quarter = std::asin(0.25 / 0.8) / (2.0 * std::numbers::pi);
    for (const Case& one : {Case{"trigger_level=0.25", at_quarter},
                            Case{"trigger_level=0.25,slope=falling", 0.5 - at_quarter},
                            Case{"trigger_level=-0.25,invert1=on", 0.5 - at_quarter},
                            Case{"trigger_level=-0.25,invert1=on,slope=falling", at_quarter}}) {
        INFO(one.settings);
        const auto signal =
            signal_of("audio:a.wav,mode=waveform,channel=left,sdiv=0.002," + one.settings, sound);
        const double sign = one.settings.find("invert") == std::string::npos ? 1.0 : -1.0;
        const double slope = 0.8 * 2.0 * std::numbers::pi * hertz;  // V/s at most
        for (const BeamPoint& point : beam_of(*signal, {0.0, 1.9})) {
            if (point.intensity == 0.0f)
                continue;
            const double seconds = 0.01 * (point.x + 1.0);
            const double expected = 0.8 * sine_at(1.0, one.turns + hertz * seconds);
            REQUIRE(std::abs(sign * point.y - expected) < 0.2 * slope / 48000.0);
        }
    }
}

TEST_CASE("a generator's trigger hides its own phase, but not the other channel's") {
    for (const std::string shape : {"sine", "triangle", "square", "saw"}) {
        INFO(shape);
        const auto signal = signal_of("waveform:ch1=" + shape +
                                      ",f1=2.3,p1=0.4,a1=1,ch2=off,trigger_level=0.4,sdiv=0.002");
        const Beam beam = beam_of(*signal, {0.0, 2.0});
        for (std::size_t i = 1; i < beam.size(); ++i)
            if (beam[i].intensity > 0.0f && beam[i - 1].intensity == 0.0f)
                REQUIRE(beam[i].y == doctest::Approx(shape == "square" ? 1.0 : 0.4).epsilon(0.02));
    }
    const auto watched =
        signal_of("waveform:f1=2,ch2=sine,f2=2,p2=0.25,a1=1,trigger_source=2,layout=overlaid");
    CHECK(beam_of(*watched, {0.0, 0.1})[1536 + 1].y == doctest::Approx(-1.0).epsilon(1e-3));
}

TEST_CASE("the trigger of a sound may use the second channel") {
    // The right channel has the same frequency, a quarter period ahead.
    const auto signal = signal_of(
        "audio:a.wav,mode=waveform,channel=both,layout=overlaid,v2=1000,trigger_source=2,sdiv=0."
        "001",
        circle(48000, 96000, 200.0));
    const Beam beam = beam_of(*signal, {0.0, 1.9});
    int sweeps = 0;
    for (std::size_t i = 1; i < beam.size(); ++i)
        if (beam[i].intensity > 0.0f && beam[i - 1].intensity == 0.0f &&
            std::abs(beam[i].y) > 0.01f) {
            ++sweeps;
            REQUIRE(std::abs(beam[i].y + 0.5f) < 0.01f);
        }
    CHECK(sweeps > 20);
}

TEST_CASE("hold-off delays the next sweep") {
    for (const std::string what : {"waveform:ch2=off,f1=2,", "audio:a.wav,mode=waveform,"}) {
        INFO(what);
        const auto signal = signal_of(what + "sdiv=0.001,holdoff=0.05", tone(100.0, 0.5));
        const auto times = sweep_times(beam_of(*signal, {0.0, 1.5}), 1.5);
        REQUIRE(times.size() > 10);
        for (std::size_t i = 1; i < times.size(); ++i) {
            CHECK(times[i] - times[i - 1] >= 0.06 - 1e-4);
            CHECK(times[i] - times[i - 1] <= 0.06 + 0.01 + 1e-4);  // waits for at most one period
        }
    }
}

TEST_CASE("without a trigger, auto free-runs and normal stays dark; single sweeps once") {
    const auto sweeps = [](const std::string& text, const std::shared_ptr<const Sound>& sound) {
        return sweep_times(beam_of(*signal_of(text, sound), {0.0, 1.0}), 1.0).size();
    };
    const auto sound = tone(100.0, 0.5);
    for (const std::string what :
         {"waveform:ch2=off,a1=0.5,sdiv=0.005,", "audio:a.wav,mode=waveform,sdiv=0.005,"}) {
        INFO(what);
        CHECK(sweeps(what + "trigger=auto,trigger_level=0.9", sound) == 20);
        CHECK(sweeps(what + "trigger=normal,trigger_level=0.9", sound) == 0);
        CHECK(sweeps(what + "trigger=normal", sound) >= 16);
        CHECK(sweeps(what + "trigger=single", sound) == 1);
        CHECK(sweeps(what + "trigger=single,trigger_level=0.9", sound) == 0);
    }
}

TEST_CASE("a burst after silence is swept from its trigger") {
    const auto sound = sound_of(
        8000, 32000, [](int i) { return i < 12000 ? 0.0 : 0.5 * sine_at(50.0, i / 8000.0); },
        [](int) { return 0.0; });
    const auto signal = signal_of(
        "audio:a.wav,mode=waveform,channel=left,sdiv=0.01,trigger_level=0.1,trigger=normal", sound);
    const auto times = sweep_times(beam_of(*signal, {0.0, 3.0}), 3.0);
    REQUIRE_FALSE(times.empty());
    CHECK(times.front() ==
          doctest::Approx(1.5 + std::asin(0.2) / (100.0 * std::numbers::pi)).epsilon(2e-4));
}

TEST_CASE("swap exchanges the inputs, but not the settings") {
    const auto sound = tone(100.0, 0.5);
    const Beam plain = beam_of(*signal_of("audio:a.wav,v1=0.5", sound), {0.0, 0.1});
    const Beam swapped = beam_of(*signal_of("audio:a.wav,v1=0.5,swap=on", sound), {0.0, 0.1});
    for (std::size_t i = 0; i < plain.size(); ++i) {
        REQUIRE(swapped[i].x == doctest::Approx(0.5 * plain[i].y));
        REQUIRE(swapped[i].y == doctest::Approx(2.0 * plain[i].x));
    }
}

TEST_CASE("two sines a quarter turn apart draw a circle to half a pixel") {
    const Beam generators =
        beam_of(*signal_of("waveform:mode=xy,ch1=sine,f1=3,p1=0.25,a1=0.9,ch2=sine,f2=3,a2=0.9"),
                frame_span(5, 60.0));
    for (const BeamPoint& point : generators)
        REQUIRE(std::abs(std::hypot(point.x, point.y) - 0.9) < 0.5 * pixel_width);
    const Beam sound = beam_of(*signal_of("audio:a.wav", circle(48000, 48000, 1000.0)), {0.2, 0.5});
    for (const BeamPoint& point : sound)
        REQUIRE(std::abs(std::hypot(point.x, point.y) - 0.5) < 0.5 * pixel_width);
}

TEST_CASE("a 2:3 Lissajous figure touches the side twice and the top three times") {
    const Beam beam = beam_of(*signal_of("lissajous:x=2,y=3,phase=0.1"), frame_span(1, 60.0));
    const auto peaks = [&](float BeamPoint::*axis) {
        int count = 0;
        for (std::size_t i = 0; i < beam.size(); ++i) {
            const float before = beam[(i + beam.size() - 1) % beam.size()].*axis;
            const float after = beam[(i + 1) % beam.size()].*axis;
            count += beam[i].*axis > before && beam[i].*axis >= after;
        }
        return count;
    };
    CHECK(peaks(&BeamPoint::x) == 2);
    CHECK(peaks(&BeamPoint::y) == 3);
}
