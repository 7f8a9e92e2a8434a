#include "signals/generators/waveform.h"

#include "about.h"
#include "signals/generators/shape.h"
#include "signals/signal_making.h"

#include <algorithm>

TEST_CASE("the waveforms have their textbook values at eighths of a period") {
    const auto at = [](Shape shape, double turns) { return wave(shape, turns, 1); };
    CHECK(at(Shape::sine, 0.125) == doctest::Approx(std::numbers::sqrt2 / 2));
    CHECK(at(Shape::triangle, 0.0) == doctest::Approx(0.0));
    CHECK(at(Shape::triangle, 0.125) == doctest::Approx(0.5));
    CHECK(at(Shape::triangle, 0.75) == doctest::Approx(-1.0));
    CHECK(at(Shape::square, 0.25) == 1.0);
    CHECK(at(Shape::square, 0.75) == -1.0);
    CHECK(at(Shape::saw, 0.25) == doctest::Approx(0.5));
    CHECK(at(Shape::saw, 0.75) == doctest::Approx(-0.5));
    CHECK(at(Shape::off, 0.3) == 0.0);
}

TEST_CASE("noise is uniform between -1 and 1, and determined by its seed") {
    double sum = 0.0;
    double squares = 0.0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
        const double level = wave(Shape::noise, i / 32.0, 7);  // without interpolation
        REQUIRE(std::abs(level) <= 1.0);
        sum += level;
        squares += level * level;
    }
    CHECK(std::abs(sum / count) < 0.01);
    CHECK(squares / count == about(1.0 / 3.0, 0.02));
    CHECK(wave(Shape::noise, 0.4, 7) == wave(Shape::noise, 0.4, 7));
    CHECK(wave(Shape::noise, 0.4, 7) != wave(Shape::noise, 0.4, 8));
}

TEST_CASE("one channel sweeps from left to right in 1/60 s") {
    const Beam beam = beam_of(*signal_of("waveform:ch2=off,f1=1,a1=0.6"), frame_span(3, 60.0));
    REQUIRE(beam.size() == 4096);
    CHECK(std::is_sorted(beam.begin(), beam.end(),
                         [](const BeamPoint& a, const BeamPoint& b) { return a.x < b.x; }));
    CHECK(beam[1023].x == doctest::Approx(-0.5));
    CHECK(beam[1023].y == doctest::Approx(0.6));
    CHECK(beam[3071].y == doctest::Approx(-0.6));
    CHECK(beam.back().x == 1.0f);
}

TEST_CASE("the retrace is blanked") {
    const Beam beam = beam_of(*signal_of("waveform"), frame_span(1, 60.0));
    CHECK(beam[0].intensity == 0.0f);
    CHECK(beam[2048].intensity == 0.0f);
    CHECK(std::count_if(beam.begin(), beam.end(),
                        [](const BeamPoint& point) { return point.intensity == 0.0f; }) == 2);
}

TEST_CASE("two channels at full amplitude do not overlap") {
    const Beam beam =
        beam_of(*signal_of("waveform:ch1=square,a1=1,ch2=noise,a2=1"), frame_span(9, 60.0));
    for (std::size_t i = 0; i < beam.size(); ++i)
        REQUIRE((i < 2048 ? beam[i].y >= 0.0f : beam[i].y < 0.0f));
}

TEST_CASE("the trace scrolls by `speed` periods per second") {
    const auto signal = signal_of("waveform:ch2=off,f1=2,a1=1,speed=15");  // a quarter per 1/60 s
    const Beam still = beam_of(*signal, frame_span(1, 60.0));
    const Beam moved = beam_of(*signal, frame_span(2, 60.0));
    CHECK(moved[99].y == doctest::Approx(still[99 + 512].y));  // a period has 2048 points
}

TEST_CASE("in xy channel 1 is x and channel 2 is y") {
    const Beam beam =
        beam_of(*signal_of("waveform:mode=xy,ch1=sine,f1=1,a1=0.5,p1=0.25,ch2=sine,f2=1,a2=0.5"),
                frame_span(1, 60.0));
    for (const BeamPoint& point : beam)
        REQUIRE(std::hypot(point.x, point.y) == about(0.5, 1e-6));
    CHECK(beam[1023].y == doctest::Approx(0.5));  // a quarter of the period
}

TEST_CASE("with both channels off there is no trace") {
    CHECK(beam_of(*signal_of("waveform:ch1=off,ch2=off"), frame_span(1, 60.0)).empty());
}
