#include "model/tuning/modulation.h"

#include "about.h"
#include "model/tuning/random_numbers.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

namespace {
Modulation lfo(LfoShape shape, double rate = 1.0, double phase = 0.0) {
    return {.shape = shape, .rate = rate, .phase = phase};
}

/// The first parameter has the range -1 .. 3 and the limit 0 .. 3.
Look moving_look() {
    Look look;
    Parameter gain;
    gain.name = "gain";
    gain.initial = Value(1.0);
    gain.range = {-1.0, 3.0, 0.0};
    gain.limit = Limit{0.0, 3.0};
    Parameter taps;
    taps.name = "taps";
    taps.type.scalar = Scalar::integer;
    taps.initial = Value(5.0);
    taps.range = {0.0, 10.0, 1.0};
    Parameter place;
    place.name = "place";
    place.type.rows = 2;
    place.control = Control::point;
    place.initial = Value({0.25, 0.5});
    look.parameters = {gain, taps, place};
    return look;
}

Value moved_to(const std::string& name, const Modulation& modulation, double seconds,
               const Values& values = {}, const Loudness* loudness = nullptr) {
    const Look look = moving_look();
    const Values now = modulated(look, values, {{name, modulation}}, seconds, loudness);
    return value_of(*find_parameter(look, name), now);
}

/// Loudness computed from the time constants.
class TestLevels : public Loudness {
public:
    double envelope(double seconds, double attack, double release) const override {
        return seconds * attack / release;
    }
    std::optional<double> seconds_since_beat(double seconds, double threshold) const override {
        return seconds < threshold ? std::nullopt : std::optional(seconds - threshold);
    }
};
}  // namespace

TEST_CASE("an LFO repeats its shape every period, from its phase") {
    const double half = std::sqrt(0.5);
    CHECK(is_near(lfo_at(lfo(LfoShape::sine), 0.125, 0), half));
    CHECK(is_near(lfo_at(lfo(LfoShape::sine, 2.0), 0.125, 0), 1.0));
    CHECK(is_near(lfo_at(lfo(LfoShape::sine, 1.0, 0.75), 3.0, 0), -1.0));
    const double triangle[] = {0.0, 0.5, 1.0, 0.5, 0.0, -0.5, -1.0, -0.5};
    const double saw[] = {-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75};
    const double square[] = {1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0};
    for (int i = 0; i < 8; ++i) {
        const double seconds = 7.0 + i / 8.0;
        CHECK(is_near(lfo_at(lfo(LfoShape::triangle), seconds, 0), triangle[i]));
        CHECK(is_near(lfo_at(lfo(LfoShape::saw), seconds, 0), saw[i]));
        CHECK(is_near(lfo_at(lfo(LfoShape::square), seconds, 0), square[i]));
        CHECK(is_near(lfo_at(lfo(LfoShape::saw, 1.0, 0.125), seconds - 0.125, 0), saw[i]));
    }
}

TEST_CASE("SplitMix64 gives the published first number for seed 0") {
    CHECK(RandomNumbers(0).next() ==
          std::ldexp(static_cast<double>(0xe220a8397b1dcdafu >> 11), -53));
}

TEST_CASE("random steps last one period, are uniform in -1..1, and differ by seed") {
    const Modulation steps = lfo(LfoShape::random, 4.0);
    double sum = 0.0;
    double squares = 0.0;
    int same = 0;
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
        const double number = lfo_at(steps, i / 4.0, 1);
        CHECK(std::abs(number) <= 1.0);
        CHECK(lfo_at(steps, i / 4.0 + 0.2499, 1) == number);
        same += lfo_at(steps, (i + 1) / 4.0, 1) == number || lfo_at(steps, i / 4.0, 2) == number;
        sum += number;
        squares += number * number;
    }
    CHECK(same == 0);
    // A uniform distribution on -1..1 has mean 0 and variance 1/3; four standard errors of each.
    CHECK(std::abs(sum / count) < 4.0 / std::sqrt(3.0 * count));
    CHECK(std::abs(squares / count - 1.0 / 3.0) < 4.0 * std::sqrt(4.0 / 45.0 / count));
}

TEST_CASE(
    "modulation moves a value by depth times range around its setting, within the hard limit") {
    Modulation moving = lfo(LfoShape::sine, 1.0);
    moving.depth = 0.25;
    CHECK(is_near(moved_to("gain", moving, 0.25).number(), 2.0));  // 1 + 0.25 * 4 * 1
    CHECK(is_near(moved_to("gain", moving, 0.25, {{"gain", Value(1.5)}}).number(), 2.5));
    CHECK(is_near(moved_to("gain", moving, 0.25, {{"gain", Value(2.5)}}).number(), 3.0));
    moving.depth = -0.125;
    CHECK(is_near(moved_to("gain", moving, 0.25).number(), 0.5));
    moving.depth = 1.0;
    CHECK(is_near(moved_to("gain", moving, 0.75).number(), 0.0));
}

TEST_CASE("integers stay whole under modulation, and both components of a point move") {
    Modulation moving = lfo(LfoShape::saw, 1.0);
    moving.depth = 0.37;
    CHECK(moved_to("taps", moving, 0.75) == Value(7.0));  // 5 + 0.37 * 10 * 0.5 = 6.85
    moving.depth = 0.5;
    CHECK(moved_to("place", moving, 0.75) == Value({0.5, 0.75}));
}

TEST_CASE("modulation moves each axis of a point over its own range") {
    Look look = moving_look();
    look.parameters[2].axes = {{0.0, 8.0, 0.0}, {0.0, 2.0, 0.0}};
    Modulation moving = lfo(LfoShape::square);
    moving.depth = 0.25;
    const Values now = modulated(look, {}, {{"place", moving}}, 0.0, nullptr);
    CHECK(value_of(look.parameters[2], now) == Value({2.25, 1.0}));
}

TEST_CASE("envelope follows level, beat decays exponentially, and silence has no effect") {
    const Modulation envelope{
        .kind = ModulationKind::envelope, .depth = 0.5, .attack = 0.1, .release = 0.4};
    const Modulation beat{
        .kind = ModulationKind::beat, .depth = 0.5, .release = 0.5, .threshold = 2.0};
    const TestLevels levels;
    CHECK(is_near(moved_to("gain", envelope, 2.0, {}, &levels).number(), 1.0 + 0.5 * 4.0 * 0.5));
    CHECK(is_near(moved_to("gain", beat, 2.0, {}, &levels).number(), 3.0));
    CHECK(is_near(moved_to("gain", beat, 2.5, {}, &levels).number(), 1.0 + 2.0 * std::exp(-1.0)));
    CHECK(moved_to("gain", beat, 1.9, {}, &levels) == Value(1.0));
    CHECK(moved_to("gain", envelope, 2.0) == Value(1.0));
    CHECK(moved_to("gain", beat, 2.0) == Value(1.0));
}

TEST_CASE("half floats, sharing of targets and spot size can be modulated") {
    Look look = moving_look();
    look.passes.resize(1);
    const std::string read = "$" + look.parameters[0].name;
    look.passes[0].half_floats = read;
    look.passes[0].onto = Onto{"elsewhere", read};
    look.passes[0].spot = {read, read};
    CHECK(why_unmodulated(look, look.parameters[0]).empty());
    look.passes[0].one_channel = read;
    CHECK_FALSE(why_unmodulated(look, look.parameters[0]).empty());
}

TEST_CASE("switches, lists and parameters that size a pass cannot be modulated") {
    Look look = moving_look();
    look.passes.resize(2);
    look.passes[1].repeat = Count(std::string("taps"));
    CHECK(why_unmodulated(look, look.parameters[0]).empty());
    CHECK(why_unmodulated(look, look.parameters[2]).empty());
    CHECK(why_unmodulated(look, look.parameters[1]) ==
          "'taps' can't be modulated: it sets the size or repeat count of a pass");
    look.parameters[0].type.scalar = Scalar::boolean;
    CHECK(why_unmodulated(look, look.parameters[0]) == "'gain' can't be modulated: it is a switch");
    look.parameters[0].control = Control::list;
    CHECK(why_unmodulated(look, look.parameters[0]) == "'gain' can't be modulated: it is a list");
    const Values values{{"taps", Value(3.0)}};
    CHECK(modulated(look, values, {{"taps", {}}, {"gone", {}}, {"gain", {}}}, 0.3, nullptr) ==
          values);
}

TEST_CASE("a modulation keeps only the fields of its kind, within their limits") {
    const Modulation all{.kind = ModulationKind::beat,
                         .depth = 9.0,
                         .shape = LfoShape::saw,
                         .rate = 7.0,
                         .attack = 1.0,
                         .release = 3.0,
                         .threshold = 1.5};
    CHECK(normalised(all) ==
          Modulation{.kind = ModulationKind::beat, .depth = 4.0, .release = 0.5, .threshold = 1.5});
    CHECK(summary_of(lfo(LfoShape::random, 0.5)) ==
          "LFO, random steps, rate 0.5 Hz, phase 0 turns, depth 0.25");
}

TEST_CASE("an LFO in beats follows the tempo and begins at the downbeat") {
    Modulation saw = lfo(LfoShape::saw);
    saw.is_in_beats = true;
    saw.period = 4.0;
    const Tempo tempo{150.0, 1.0, 4.0};  // a beat is 0.4 s
    CHECK(is_near(lfo_at(saw, 1.0, 0, tempo), -1.0));
    CHECK(is_near(lfo_at(saw, 1.8, 0, tempo), 0.0));
    CHECK(is_near(lfo_at(saw, 2.2, 0, tempo), 0.5));
    CHECK(is_near(lfo_at(saw, 0.2, 0, tempo), 0.0));  // half a bar before the downbeat
    saw.phase = 0.25;
    CHECK(is_near(lfo_at(saw, 1.0, 0, tempo), -0.5));
}

TEST_CASE("envelope times in beats are seconds of the tempo, within the limit in seconds") {
    Modulation envelope{.kind = ModulationKind::envelope, .depth = 0.25, .is_in_beats = true};
    envelope.attack_beats = 0.5;
    envelope.release_beats = 1.0;
    const TestLevels levels;
    const Look look = moving_look();
    const auto gain_at = [&](double bpm) {
        const Values now = modulated(look, {}, {{"gain", envelope}}, 0.5, &levels, {bpm});
        return value_of(*find_parameter(look, "gain"), now).number();
    };
    // TestLevels: seconds * attack / release, times the depth of 0.25 and the range of 4.
    CHECK(is_near(gain_at(120.0), 1.0 + 0.5 * 0.25 / 0.5));
    envelope.release_beats = 32.0;  // 16 s, but at most 2 s
    CHECK(is_near(gain_at(120.0), 1.0 + 0.5 * 0.25 / 2.0));
}

TEST_CASE("note lengths go from a sixteenth to eight bars") {
    const auto common = note_lengths(4.0);
    CHECK(common.front().label == "1/16");
    CHECK(common.front().beats == 0.25);
    CHECK(common.back().label == "8 bars");
    CHECK(common.back().beats == 32.0);
    CHECK(note_lengths(3.0).back().beats == 24.0);
}
