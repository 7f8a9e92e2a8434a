#include "model/plan/condition.h"

#include <doctest/doctest.h>

namespace {
Parameter number(const std::string& name, const std::string& label, double initial = 0.0) {
    Parameter parameter;
    parameter.name = name;
    parameter.label = label;
    parameter.initial = Value(initial);
    return parameter;
}

std::vector<Parameter> parameters_with(const std::string& when, const std::string& scope = "") {
    Parameter tube = number(scope + "tube", "Tube");
    tube.type.scalar = Scalar::integer;
    tube.items = {{0, "Custom"}, {1, "P1 \"green\""}, {5, "P7"}};
    Parameter lit = number(scope + "lit", "Lit");
    lit.type.scalar = Scalar::boolean;
    Parameter color = number(scope + "color", "Colour");
    color.type.rows = 3;
    color.initial = Value(std::vector<double>{1.0, 1.0, 1.0});
    Parameter blur = number(scope + "blur", "Blur", 0.25);
    Parameter taps = number(scope + "taps", "Taps");
    taps.when = when;
    taps.declared = {"a.frag", 7};
    return {tube, lit, color, blur, taps};
}

bool is_true(const std::string& when, const Values& values = {}) {
    const auto parameters = parameters_with(when);
    REQUIRE(check_conditions(parameters).empty());
    return is_condition_true(parameters.back(), parameters, values);
}

std::string text(const std::string& when) {
    const auto parameters = parameters_with(when);
    REQUIRE(check_conditions(parameters).empty());
    return condition_text(parameters.back(), parameters);
}

std::string condition_problem(const std::string& when) {
    const Diagnostics problems = check_conditions(parameters_with(when));
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].file == "a.frag");
    CHECK(problems[0].line == 7);
    CHECK(problems[0].message.starts_with("@when of 'taps': "));
    return problems[0].message.substr(17);
}
}  // namespace

TEST_CASE("a condition compares parameters with numbers, items and each other") {
    CHECK(is_true(""));
    CHECK(is_true("blur == 0.25"));
    CHECK_FALSE(is_true("blur > .25"));
    CHECK(is_true("blur >= 0.25 && blur <= 0.25"));
    CHECK(is_true("blur != -1"));
    CHECK(is_true("tube == \"Custom\""));
    CHECK_FALSE(is_true("tube == \"P7\""));
    CHECK(is_true("tube == \"P7\"", {{"tube", Value(5.0)}}));
    CHECK(is_true("\"P7\" == tube", {{"tube", Value(5.0)}}));
    CHECK(is_true("tube==\"P1 \\\"green\\\"\"", {{"tube", Value(1.0)}}));
    CHECK(is_true("blur < lit", {{"lit", Value(1.0)}}));
}

TEST_CASE("not binds tighter than and, and and tighter than or") {
    CHECK(is_true("!lit"));
    CHECK_FALSE(is_true("lit"));
    CHECK(is_true("lit || blur > 0"));
    CHECK_FALSE(is_true("lit && blur > 0"));
    CHECK(is_true("blur || lit && lit"));
    CHECK_FALSE(is_true("(blur || lit) && lit"));
    CHECK_FALSE(is_true("!(lit || blur > 0)"));
    CHECK(is_true("!lit == 1"));
}

TEST_CASE("a condition in a stack reads the parameters of its own look") {
    auto parameters = parameters_with("!lit", "crt/");
    const auto others = parameters_with("lit", "phosphor/");
    parameters.insert(parameters.begin(), others.begin(), others.end());
    CHECK(check_conditions(parameters).empty());
    const Values values{{"phosphor/lit", Value(1.0)}};
    CHECK(is_condition_true(parameters.back(), parameters, values));
    CHECK(is_condition_true(parameters[4], parameters, values));
    CHECK_FALSE(is_condition_true(parameters[4], parameters, {}));
    CHECK(condition_text(parameters.back(), parameters) == "Lit is off");
}

TEST_CASE("the text of a condition has labels instead of names") {
    CHECK(text("tube == \"Custom\" || lit") == "Tube is Custom or Lit is on");
    CHECK(text("!lit && tube != \"P7\"") == "Lit is off and Tube is not P7");
    CHECK(text("(blur > 0 || lit) && tube == 5") ==
          "(Blur is above 0 or Lit is on) and Tube is P7");
    CHECK(text("blur >= -0.5") == "Blur is at least -0.5");
    CHECK(text("!(blur < lit)") == "not (Blur is below Lit)");
    CHECK(text("lit == 1") == "Lit is on");
    CHECK(text("blur") == "Blur is not 0");
}

TEST_CASE("an invalid condition gives a specific error") {
    CHECK(condition_problem("tub == 1") == "no parameter 'tub' (did you mean 'tube'?)");
    CHECK(condition_problem("tube == \"P8\"") == "'tube' has no item \"P8\" (did you mean 'P7'?)");
    CHECK(condition_problem("\"P7\"") == "\"P7\" is not compared with a parameter");
    CHECK(condition_problem("tube == \"P7") == "a label has no closing '\"'");
    CHECK(condition_problem("color == 1") == "'color' is not a single number");
    CHECK(condition_problem("blur = 1") == "unexpected '='");
    CHECK(condition_problem("blur + 1") == "unexpected '+'");
    CHECK(condition_problem("(blur > 1") == "missing ')'");
    CHECK(condition_problem("blur > 1 2") == "unexpected '2 '");
    CHECK(condition_problem("max(blur, 1)") == "no parameter 'max'");
}
