#include "model/picture/gain.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
/// Two passes that use a ceiling of 4: one keeps light, one computes with it.
Look tube() {
    Look look;
    look.passes.resize(3);
    look.passes[0].name = "beam";
    look.passes[1].name = "persistence";
    look.passes[1].inputs = {{"previous", Input::From::pass, "persistence", 1, {}}};
    look.passes[2].name = "screen";
    look.passes[2].format = Format::rgba8;
    Parameter ceiling;
    ceiling.name = "ceiling";
    ceiling.initial = Value(4.0);
    ceiling.bindings = {{0, "ceiling"}, {1, "ceiling"}};
    look.parameters = {ceiling};
    return look;
}
}  // namespace

TEST_CASE("headroom is the number of stops from the peak to the ceiling") {
    const Statistics statistics{.minimum = 0.0, .maximum = 0.5, .mean = 0.125, .finite = 200};
    const TargetLevel gain = target_level_of(statistics, 50, 4.0);
    CHECK(gain.peak == 0.5);
    CHECK(gain.mean == 0.125);
    CHECK(gain.clipped == 0.25);
    CHECK(headroom_stops(gain) == 3.0);
    CHECK(headroom_stops(target_level_of({.maximum = 4.0, .finite = 1}, 1, 4.0)) == 0.0);
    CHECK(headroom_stops(target_level_of({.maximum = 8.0, .finite = 1}, 1, 4.0)) == -1.0);
    CHECK_FALSE(headroom_stops(target_level_of({.finite = 1}, 0, 4.0)));
    CHECK(target_level_of({}, 0, 1.0).clipped == 0.0);
}

TEST_CASE("the clipped share is of all texels, those with a NaN included") {
    CHECK(target_level_of({.finite = 1, .not_a_number = 2, .infinite = 1}, 1, 1.0).clipped == 0.25);
}

TEST_CASE("the limit of a format is its largest finite number") {
    CHECK(format_limit(Format::rgba8) == 1.0);
    CHECK(format_limit(Format::rgba16f) == 65504.0);  // IEEE 754-2008, binary16
    CHECK(format_limit(Format::r32f) == std::ldexp(2.0 - std::ldexp(1.0, -23), 127));
    CHECK(format_limit(Format::r32ui) == std::exp2(32.0) - 1.0);
    CHECK(format_limit(Format::rgba8i) == std::exp2(7.0) - 1.0);
    CHECK(format_limit(Format::rg16i) == std::exp2(15.0) - 1.0);
    CHECK(format_limit(Format::r32i) == std::exp2(31.0) - 1.0);
}

TEST_CASE("a ceiling applies to the pass that keeps light, or else to each pass that has it") {
    Look look = tube();
    CHECK(ceiling_of(look, 0, {}) == 65504.0);
    CHECK(ceiling_of(look, 1, {}) == 4.0);
    CHECK(ceiling_of(look, 1, {{"ceiling", Value(7.0)}}) == 7.0);
    CHECK(ceiling_of(look, 2, {}) == 1.0);
    look.passes[1].inputs.clear();
    CHECK(ceiling_of(look, 0, {}) == 4.0);
    look.parameters[0].name = "phosphor/ceiling";
    CHECK(ceiling_of(look, 1, {{"phosphor/ceiling", Value(2.0)}}) == 2.0);
}

TEST_CASE("a ceiling rounded down to a half float still counts as clipped") {
    CHECK(clips_from(1.0) == 2047.0 / 2048.0);
    CHECK(clips_from(1.0) < 1.0);
    CHECK(clips_from(1.0) > 1022.0 / 1023.0);  // one step below full in rgb10_a2 is not clipped
}

TEST_CASE("a level meter has a range of 16 stops") {
    CHECK(meter_ratio(2.0, 2.0) == 1.0);
    CHECK(meter_ratio(1.0, 256.0) == 0.5);
    CHECK(meter_ratio(5.0, 2.0) == 1.0);
    CHECK(meter_ratio(1e-9, 1.0) == 0.0);
    CHECK(meter_ratio(0.0, 1.0) == 0.0);
    CHECK(meter_ratio(-1.0, 1.0) == 0.0);
}
