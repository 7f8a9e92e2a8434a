#include "model/tuning/parameter_settings.h"

#include <doctest/doctest.h>

namespace {
Parameter parameter_named(const std::string& name) {
    Parameter parameter;
    parameter.name = name;
    parameter.label = name;
    parameter.initial = Value(0.5);
    parameter.limit = Limit{0.0, 10.0};
    return parameter;
}

const ParameterSetting starred{.is_favourite = true};
const ParameterSetting locked{.is_locked = true};
}  // namespace

TEST_CASE("favourites and locks follow a renamed parameter") {
    Look look;
    look.parameters = {parameter_named("glow"), parameter_named("gain")};
    look.parameters[0].was = "decay";
    const ParameterSettings settings =
        renamed_settings(look, {{"decay", starred}, {"gain", locked}});
    CHECK(settings == ParameterSettings{{"glow", starred}, {"gain", locked}});
}

TEST_CASE("parameter settings of a look also apply in a stack, and are stored by the look's id") {
    const Stack stack{{"phosphor", {}, "a"}, {"crt", {}, "b"}, {"crt", {}, "c"}};
    const LookParameterSettings looks{{"crt", {{"gain", locked}}}, {"other", {{"gain", starred}}}};
    ParameterSettings settings = settings_in(stack, looks);
    CHECK(settings == ParameterSettings{{"crt/gain", locked}, {"crt#2/gain", locked}});
    settings["phosphor/decay"] = starred;
    settings.erase("crt/gain");
    LookParameterSettings stored = looks;
    store_settings(stored, stack, settings);
    CHECK(stored == LookParameterSettings{{"phosphor", {{"decay", starred}}},
                                          {"other", {{"gain", starred}}}});
    CHECK(settings_in({{"phosphor", {}, "a"}}, stored) == ParameterSettings{{"decay", starred}});
}

TEST_CASE("custom ends of a slider are clamped to the hard limit and must differ") {
    Parameter parameter = parameter_named("gain");
    CHECK(fitted_ends(parameter, {2.0, 99.0}) == Limit{2.0, 10.0});
    const auto refused = fitted_ends(parameter, {20.0, 30.0});
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().front().message.ends_with("got 20 and 30"));
    CHECK_FALSE(fitted_ends(parameter, {3.0, 3.0}).has_value());
    parameter.type.scalar = Scalar::integer;
    CHECK(fitted_ends(parameter, {1.4, 3.6}) == Limit{1.0, 4.0});
    CHECK_FALSE(fitted_ends(parameter, {1.1, 1.3}).has_value());
}

TEST_CASE("valid custom ends replace the range of a slider") {
    const Parameter parameter = parameter_named("gain");
    CHECK(with_ends(parameter, {.ends = Limit{2.0, 4.0}}).range == Range{2.0, 4.0});
    CHECK(with_ends(parameter, {}).range == parameter.range);
    CHECK(with_ends(parameter, {.ends = Limit{20.0, 40.0}}).range == parameter.range);
}
