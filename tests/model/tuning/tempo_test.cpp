#include "model/tuning/tempo.h"

#include "model/tuning/tap_tempo.h"

#include <doctest/doctest.h>

#include <limits>

TEST_CASE("beats count from the downbeat") {
    const Tempo tempo{90.0, 1.0, 3.0};
    CHECK(tempo.beats_at(1.0) == 0.0);
    CHECK(tempo.beats_at(3.0) == doctest::Approx(3.0));
    CHECK(tempo.bars_at(3.0) == doctest::Approx(1.0));
    CHECK(tempo.beats_at(0.0) == doctest::Approx(-1.5));
    CHECK(tempo.seconds_at(3.0) == doctest::Approx(3.0));
}

TEST_CASE("another tempo continues the beat where it is") {
    const Tempo before{120.0, 0.25, 4.0};
    const Tempo after = with_bpm(before, 174.0, 10.0);
    CHECK(after.bpm == 174.0);
    CHECK(after.beats_at(10.0) == doctest::Approx(before.beats_at(10.0)));
    CHECK(with_bpm(before, 1e9, 10.0).bpm == max_bpm);
}

TEST_CASE("a tempo from a file is finite and within its limits") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(normalised({nan, nan, nan}) == Tempo{});
    CHECK(normalised({1.0, 0.5, 99.0}) == Tempo{min_bpm, 0.5, max_beats_per_bar});
}

TEST_CASE("the tempo of taps is that of the median interval") {
    TapTempo taps;
    CHECK_FALSE(taps.tap(10.0).has_value());
    CHECK(taps.tap(10.5) == doctest::Approx(120.0));
    CHECK(taps.tap(11.0) == doctest::Approx(120.0));
    CHECK(taps.tap(11.9) == doctest::Approx(120.0));  // a late tap: 0.5, 0.5, 0.9
    CHECK(taps.tap(12.0) == doctest::Approx(120.0));  // 0.1, 0.5, 0.5, 0.9
}

TEST_CASE("after two seconds a new series of taps begins") {
    TapTempo taps;
    taps.tap(0.0);
    taps.tap(0.5);
    CHECK_FALSE(taps.tap(2.6).has_value());
    CHECK(taps.count() == 1);
    CHECK(taps.tap(3.6) == doctest::Approx(60.0));
}
