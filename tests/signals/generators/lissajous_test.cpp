#include "signals/generators/lissajous.h"

#include "about.h"
#include "signals/signal/sine.h"
#include "signals/signal_making.h"

namespace {
// How often a closed path reaches the maximum of a coordinate.
int touches(const Beam& beam, float BeamPoint::*coordinate, float edge) {
    int count = 0;
    bool was_near = beam.back().*coordinate > edge;
    for (const BeamPoint& point : beam) {
        const bool is_near = point.*coordinate > edge;
        count += is_near && !was_near;
        was_near = is_near;
    }
    return count;
}
}  // namespace

TEST_CASE("a 2:3 figure touches the right edge twice and the top edge three times") {
    const Beam beam = beam_of(*signal_of("lissajous:x=2,y=3,phase=0.07"), frame_span(1, 60.0));
    REQUIRE(beam.size() == 4096);
    CHECK(touches(beam, &BeamPoint::x, 0.7999f) == 2);
    CHECK(touches(beam, &BeamPoint::y, 0.7999f) == 3);
}

TEST_CASE("1:1 with a quarter turn is a circle") {
    const Beam beam =
        beam_of(*signal_of("lissajous:x=1,y=1,phase=0.25,amplitude=0.5"), frame_span(7, 60.0));
    for (const BeamPoint& point : beam)
        REQUIRE(std::hypot(point.x, point.y) == about(0.5, 1e-6));
}

TEST_CASE("a figure with integer ratios is the same in every 1/60 s, also after an hour") {
    const auto signal = signal_of("lissajous:x=3,y=2");
    const Beam first = beam_of(*signal, frame_span(1, 60.0));
    const Beam late = beam_of(*signal, frame_span(216001, 60.0));
    REQUIRE(first.size() == late.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        REQUIRE(std::abs(first[i].x - late[i].x) < 1e-6);
        REQUIRE(std::abs(first[i].y - late[i].y) < 1e-6);
    }
}

TEST_CASE("x = 1.5 closes after two periods") {
    const auto signal = signal_of("lissajous:x=1.5,y=1,phase=0");
    const Beam first = beam_of(*signal, frame_span(1, 60.0));
    const Beam second = beam_of(*signal, frame_span(2, 60.0));
    const Beam third = beam_of(*signal, frame_span(3, 60.0));
    CHECK(first[100].x == doctest::Approx(-second[100].x));
    CHECK(first[100].x == doctest::Approx(third[100].x));
    CHECK(first[100].y == doctest::Approx(second[100].y));
}

TEST_CASE("the phase drifts by `speed` turns per second") {
    const auto drifting = signal_of("lissajous:x=3,y=2,phase=0,speed=0.5");
    const auto still = signal_of("lissajous:x=3,y=2,phase=0.5");
    const BeamPoint after_one_second = beam_of(*drifting, frame_span(60, 60.0)).back();
    const BeamPoint half_a_turn_on = beam_of(*still, frame_span(60, 60.0)).back();
    CHECK(after_one_second.x == doctest::Approx(half_a_turn_on.x).epsilon(1e-6));
    CHECK(after_one_second.y == doctest::Approx(half_a_turn_on.y).epsilon(1e-6));
}

TEST_CASE("ages decrease from almost one frame to zero") {
    const Beam beam = beam_of(*signal_of("lissajous"), frame_span(1000, 60.0));
    CHECK(beam.front().age_seconds == about(4095.0 / 4096.0 / 60.0, 1e-5));
    CHECK(std::abs(beam.back().age_seconds) < 1e-9);
}

TEST_CASE("weighted by speed, a resting beam has full current and the fastest has the least") {
    // x is a sine: at rest at its ends, fastest in the middle, where s = 1.
    const Beam beam = beam_of(*signal_of("lissajous:x=1,y=0,phase=0,amplitude=1,weighting=speed"),
                              frame_span(1, 60.0));
    CHECK(beam[1023].x == doctest::Approx(1.0));
    CHECK(beam[1023].intensity == doctest::Approx(1.0));
    CHECK(beam[2047].x == doctest::Approx(0.0));
    CHECK(beam[2047].intensity == doctest::Approx(0.3 + 0.7 * 0.05 / 1.05));
}

TEST_CASE("the fast sine in turns matches the standard library") {
    for (int i = -5000; i <= 5000; ++i) {
        const double turns = i * 0.00137;
        REQUIRE(std::abs(sine(turns) - sine_at(1.0, turns)) < 2e-11);
        REQUIRE(std::abs(cosine(turns) - sine_at(1.0, turns + 0.25)) < 2e-11);
    }
    CHECK(fraction(-0.25) == 0.75);
    CHECK(fraction(7.5) == 0.5);
}
