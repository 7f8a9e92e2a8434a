#include "model/tuning/cue_plan.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
/// `gain` and `level` are linear, `mode` is a whole number.
Look cued_look() {
    Look look;
    for (const char* name : {"gain", "level", "mode"}) {
        Parameter parameter;
        parameter.name = name;
        parameter.initial = Value(1.0);
        parameter.range = {0.0, 10.0, 0.0};
        look.parameters.push_back(parameter);
    }
    look.parameters[2].type.scalar = Scalar::integer;
    return look;
}

CueAction set(double seconds, const std::string& name, double value, double over = 0.0) {
    return {.seconds = seconds, .over = over, .values = {{name, Value(value)}}};
}

double value_at(const CuePlan& plan, double position, const std::string& name = "gain",
                const Values& without = {}) {
    const Look look = cued_look();
    const CuedState state = plan.state_at(look, {without, {}}, position);
    return value_of(*find_parameter(look, name), state.values).number();
}
}  // namespace

TEST_CASE("a cue holds from its time on, also if the position was rounded") {
    const CuePlan plan({set(2.0, "gain", 5.0), set(1.0, "gain", 3.0)});  // in any order
    CHECK(value_at(plan, 0.999) == 1.0);
    CHECK(value_at(plan, 1.0 - 1e-9) == 3.0);
    CHECK(value_at(plan, 1.999) == 3.0);
    CHECK(value_at(plan, 2.0) == 5.0);
    CHECK(value_at(plan, 0.5) == 1.0);  // after a seek back
    CHECK(value_at(plan, 5.0, "level") == 1.0);
    CHECK(value_at(plan, 0.5, "gain", {{"gain", Value(7.0)}}) == 7.0);
}

TEST_CASE("a change takes its time, from the value at its start") {
    const CuePlan plan({set(1.0, "gain", 5.0, 2.0)});
    CHECK(value_at(plan, 1.0) == 1.0);
    CHECK(value_at(plan, 2.0) == doctest::Approx(3.0));
    CHECK(value_at(plan, 3.0) == 5.0);
    CHECK(value_at(plan, 2.0, "gain", {{"gain", Value(0.0)}}) == doctest::Approx(2.5));
}

TEST_CASE("a change during another one starts where that one is") {
    // 1 to 5 from 0 s to 4 s, then from 3 at 2 s to 0 at 4 s.
    const CuePlan plan({set(0.0, "gain", 5.0, 4.0), set(2.0, "gain", 0.0, 2.0)});
    CHECK(value_at(plan, 1.0) == doctest::Approx(2.0));
    CHECK(value_at(plan, 2.0) == doctest::Approx(3.0));
    CHECK(value_at(plan, 3.0) == doctest::Approx(1.5));
    CHECK(value_at(plan, 4.0) == 0.0);
}

TEST_CASE("a preset changes all its parameters, and its modulations at the end") {
    CueAction preset{.seconds = 1.0,
                     .over = 2.0,
                     .values = {{"gain", Value(3.0)}, {"mode", Value(4.0)}},
                     .modulations = Modulations{{"gain", {}}}};
    const CuePlan plan({preset, set(2.0, "gain", 9.0)});
    const Look look = cued_look();
    CHECK(value_at(plan, 1.5) == doctest::Approx(1.5));
    CHECK(value_at(plan, 1.5, "mode") == 1.0);  // whole numbers change at half time
    CHECK(value_at(plan, 2.5, "mode") == 4.0);
    CHECK(value_at(plan, 2.5) == 9.0);
    CHECK(plan.state_at(look, {}, 2.9).modulations.empty());
    CHECK(plan.state_at(look, {}, 3.0).modulations.contains("gain"));
    CHECK(plan.changes("mode"));
    CHECK_FALSE(plan.changes("level"));
}

TEST_CASE("the picture is black between blackout on and off") {
    const CuePlan plan({{.seconds = 1.0, .kind = CueAction::Kind::blackout},
                        {.seconds = 2.0, .kind = CueAction::Kind::blackout, .is_on = false}});
    CHECK_FALSE(plan.is_black_at(0.9));
    CHECK(plan.is_black_at(1.0));
    CHECK(plan.is_black_at(1.9));
    CHECK_FALSE(plan.is_black_at(2.0));
}

TEST_CASE("a restart happens in exactly one frame, also over the end of a loop") {
    const CuePlan plan({{.seconds = 1.0, .kind = CueAction::Kind::restart}});
    int restarts = 0;
    for (int i = 0; i < 120; ++i)
        restarts += plan.restarts_within(i / 60.0, (i + 1) / 60.0, 0.0, 9.0) ? 1 : 0;
    CHECK(restarts == 1);
    CHECK(plan.restarts_within(0.99, 0.2, 0.1, 1.01));    // the loop ends after 1 s
    CHECK(plan.restarts_within(3.99, 1.005, 0.99, 4.0));  // it starts before 1 s
    CHECK_FALSE(plan.restarts_within(3.99, 0.5, 0.2, 4.0));
    CHECK_FALSE(plan.restarts_within(3.99, 2.0, 1.5, 4.0));  // the cue is before the loop
    CHECK_FALSE(plan.restarts_within(0.79, 0.2, 0.1, 0.8));  // it is after the loop
}

TEST_CASE("thousands of overlapping cues are evaluated without recursion") {
    // Each begins 1 ms after the previous one, which has covered 1e-5 of its way to 3 by then.
    std::vector<CueAction> actions;
    for (int i = 0; i < 10'000; ++i)
        actions.push_back(set(i * 0.001, "gain", 3.0, 100.0));
    const CuePlan plan(std::move(actions));
    const double left = 2.0 * std::pow(1.0 - 1e-5, 9'999);  // when the last one begins, from 1
    CHECK(value_at(plan, 9.999 + 50.0) == doctest::Approx(3.0 - left / 2).epsilon(1e-6));
}
