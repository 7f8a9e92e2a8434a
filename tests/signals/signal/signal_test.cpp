#include "signals/signal/signal.h"

#include "about.h"
#include "signals/signal_making.h"
#include "signals/signal_table.h"

#include <algorithm>
#include <random>
#include <string>

namespace {
const std::vector<std::string> every_way_to_draw{
    "lissajous:speed=0.3,x=2.5",
    "lissajous:points=1000,weighting=speed",
    "waveform:ch1=square,ch2=noise,speed=1.7",
    "waveform:mode=xy,ch1=triangle",
    "waveform:ch1=off,points=333",
    "harmonics:count=9,shape=square,speed=0.2",
    "harmonics:mode=xy",
    "am",
    "am:mode=xy",
    "fm:points=16384",
    "fm:mode=xy",
    "audio:a.wav",
    "audio:a.wav,upsample=1,loop=off",
    "audio:a.wav,upsample=16,auto_gain=on,start=0.5",
    "audio:a.wav,mode=waveform,trigger=off,sdiv=0.0013",
    "audio:a.wav,mode=waveform,channel=both,trigger=off,sdiv=0.0021,upsample=1",
    "audio:a.wav,mode=waveform,channel=both,trigger_source=2,upsample=3,swap=on,invert1=on",
    "audio:a.wav,mode=waveform,channel=right,coupling2=ac,holdoff=0.01,trigger=normal",
    "audio:a.wav,mode=waveform,sdiv=0.05,trigger=single,slope=falling,trigger_level=0.2",
    "audio:a.wav,mode=spectrum,fft=1024,loop=off",
    "audio:a.wav,mode=radial,smoothing=0.02",
    "audio:a.wav,coupling1=ac,coupling2=gnd,v1=0.5,o2=-1",
    "drawing:strokes=[L-0.5 -0.5 0.5 0.5;S0 0.3 0.2 0 0.5 0.1z][S-0.9 0 0 0.5 0.8 0],spin=20",
};

std::shared_ptr<const Sound> test_sound() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> level(-1.0, 1.0);
    return sound_of(
        44100, 66150, [&](int) { return level(random); },
        [](int i) { return 0.8 * sine_at(97.0, i / 44100.0); });
}

std::vector<TimeSpan> random_cuts(double start, double end, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(start, end);
    std::vector<double> times{start, end};
    for (int i = 0; i < 40; ++i)
        times.push_back(place(random));
    std::sort(times.begin(), times.end());
    std::vector<TimeSpan> spans;
    for (std::size_t i = 1; i < times.size(); ++i)
        spans.push_back({times[i - 1], times[i]});
    return spans;
}

bool is_same_point(const BeamPoint& a, const BeamPoint& b) {
    return a.x == b.x && a.y == b.y && a.intensity == b.intensity;
}
}  // namespace

TEST_CASE("every point occurs exactly once for any division of time into frames") {
    const auto sound = test_sound();
    for (const std::string& text : every_way_to_draw) {
        INFO(text);
        const auto signal = signal_of(text, sound);
        for (const double start : {0.0, 3600.0}) {
            const TimeSpan whole{start, start + 1.7};
            const Beam expected = beam_of(*signal, whole);
            Beam pieces;
            bool ages_fit = true;
            for (const TimeSpan& span : random_cuts(whole.start, whole.end, 3)) {
                const std::size_t before = pieces.size();
                signal->trace(span, pieces);
                for (std::size_t i = before; i < std::min(pieces.size(), expected.size()); ++i)
                    ages_fit &= std::abs(pieces[i].age_seconds + (whole.end - span.end) -
                                         expected[i].age_seconds) < 1e-6;
            }
            REQUIRE(pieces.size() == expected.size());
            CHECK(std::equal(pieces.begin(), pieces.end(), expected.begin(), is_same_point));
            CHECK(ages_fit);
        }
    }
}

TEST_CASE("a full current gives the same light for any number of points") {
    const auto sound = test_sound();
    for (const std::string& text : every_way_to_draw) {
        if (text.find("weighting") != std::string::npos ||
            (text.find("mode=waveform") != std::string::npos &&
             text.find("trigger=off") == std::string::npos) ||
            text.starts_with("drawing"))
            continue;  // these dim the beam on purpose
        INFO(text);
        const Beam beam = beam_of(*signal_of(text, sound), {0.0, 1.0});
        double light = 0.0;
        for (const BeamPoint& point : beam)
            light += point.intensity;
        CHECK(light == about(4096.0 * 60.0, 1e-3));
    }
}

TEST_CASE("points are appended and lie on the screen") {
    const auto sound = test_sound();
    for (const std::string& text : every_way_to_draw) {
        INFO(text);
        Beam beam(1, BeamPoint{9.0f, 9.0f, 9.0f, 9.0f});
        signal_of(text, sound)->trace(frame_span(1, 60.0), beam);
        REQUIRE(beam.size() > 1);
        CHECK(beam.front().x == 9.0f);
        // Interpolated noise exceeds its samples.
        const float edge = text.starts_with("audio") ? 3.0f : 1.0f;
        CHECK(std::all_of(beam.begin() + 1, beam.end(), [=](const BeamPoint& point) {
            return std::abs(point.x) <= edge && std::abs(point.y) <= edge &&
                   point.age_seconds >= 0.0f && point.age_seconds <= 1.0f / 60.0f;
        }));
    }
}

TEST_CASE("every signal stays finite at the limits of its settings") {
    const auto sound = test_sound();
    for (const SignalKind& kind : signal_kinds()) {
        for (const SettingInfo& setting : kind.settings) {
            if (setting.type != SettingType::number)
                continue;
            for (const double value : {setting.limit.low, setting.limit.high}) {
                INFO(kind.kind << ' ' << setting.key << ' ' << value);
                Spec spec{kind.kind, {{setting.key, value}}};
                if (!kind.file_setting.empty())
                    spec.settings[kind.file_setting] = std::string("a.wav");
                const auto signal = make_signal(spec, {sound});
                if (!signal)
                    continue;  // such as a start after the end of the sound
                for (const BeamPoint& point : beam_of(**signal, frame_span(7, 60.0)))
                    REQUIRE(std::isfinite(point.x + point.y + point.intensity));
            }
        }
    }
}
