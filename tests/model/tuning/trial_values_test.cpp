#include "model/tuning/trial_values.h"

#include <doctest/doctest.h>

namespace {
Parameter slider() {
    Parameter parameter;
    parameter.name = "gain";
    parameter.label = "Gain";
    parameter.initial = Value(0.5);
    parameter.range = {0.0, 1.0, 0.1};
    return parameter;
}
}  // namespace

TEST_CASE("the trial values of a slider are one step and both ends") {
    const Parameter gain = slider();
    const auto found = trial_values(gain, Value(0.5));
    REQUIRE(found.size() == 3);
    CHECK(found[0].number() == doctest::Approx(0.6));
    CHECK(found[1] == Value(1.0));
    CHECK(found[2] == Value(0.0));
    // At an end, the step goes the other way.
    CHECK(trial_values(gain, Value(1.0)).front().number() == doctest::Approx(0.9));
    CHECK(trial_values(gain, Value(1.0)).back() == Value(0.0));
}

TEST_CASE("the trial values of a list are all other items") {
    Parameter mode = slider();
    mode.control = Control::list;
    mode.items = {{0.0, "Off"}, {1.0, "Low"}, {5.0, "High"}};
    CHECK(trial_values(mode, Value(1.0)) == std::vector<Value>{Value(0.0), Value(5.0)});
}

TEST_CASE("the trial value of a switch is its other state") {
    Parameter is_on = slider();
    is_on.type.scalar = Scalar::boolean;
    is_on.range = {0.0, 1.0};
    CHECK(trial_values(is_on, Value(1.0)) == std::vector<Value>{Value(0.0)});
}

TEST_CASE("a vector moves all components to an end") {
    Parameter size = slider();
    size.type.rows = 2;
    const auto found = trial_values(size, Value({0.5, 1.0}));
    CHECK(found.back() == Value({0.0, 0.0}));
}

TEST_CASE("images, sounds, events and matrices have no trial values") {
    Parameter other = slider();
    for (const Control control : {Control::image, Control::sound, Control::event}) {
        other.control = control;
        CHECK(trial_values(other, Value(0.0)).empty());
    }
    other.control = Control::slider;
    other.type = {Scalar::floating, 2, 2};
    CHECK(trial_values(other, Value({1.0, 0.0, 0.0, 1.0})).empty());
}
