#include "model/tuning/randomised.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace {
Parameter parameter_named(const std::string& name, Range range, Scale scale = Scale::linear) {
    Parameter parameter;
    parameter.name = name;
    parameter.initial = Value(range.low);
    parameter.range = range;
    parameter.scale = scale;
    return parameter;
}

Look look_of(std::vector<Parameter> parameters) {
    Look look;
    look.parameters = std::move(parameters);
    return look;
}

// The values of one parameter for many seeds.
std::vector<Value> rolls(const Parameter& parameter, int count = 4000,
                         const ParameterSetting& setting = {}) {
    const Look look = look_of({parameter});
    std::vector<Value> values;
    for (int seed = 0; seed < count; ++seed)
        values.push_back(randomised_values(look, {}, {{parameter.name, setting}},
                                           {static_cast<std::uint64_t>(seed)})
                             .at(parameter.name));
    return values;
}

std::vector<double> numbers(const std::vector<Value>& values, std::size_t component = 0) {
    std::vector<double> all;
    for (const Value& value : values)
        all.push_back(value.numbers.at(component));
    std::sort(all.begin(), all.end());
    return all;
}

// The share of the values below `end`. With 4000 samples its standard deviation is at most 0.008.
double share_below(const std::vector<double>& sorted, double end) {
    const auto below = std::lower_bound(sorted.begin(), sorted.end(), end) - sorted.begin();
    return static_cast<double>(below) / static_cast<double>(sorted.size());
}
constexpr double spread = 0.03;
}  // namespace

TEST_CASE("random values are uniform over the soft range") {
    const auto all = numbers(rolls(parameter_named("a", {2.0, 6.0})));
    CHECK(all.front() >= 2.0);
    CHECK(all.back() <= 6.0);
    for (const double place : {0.1, 0.25, 0.5, 0.75, 0.9})
        CHECK(std::abs(share_below(all, 2.0 + 4.0 * place) - place) < spread);
}

TEST_CASE("random values of a logarithmic slider are uniform in ratio") {
    const auto all = numbers(rolls(parameter_named("a", {0.01, 100.0}, Scale::logarithmic)));
    CHECK(std::abs(share_below(all, 0.1) - 0.25) < spread);
    CHECK(std::abs(share_below(all, 1.0) - 0.5) < spread);
    CHECK(std::abs(share_below(all, 10.0) - 0.75) < spread);
}

TEST_CASE("random steps, integers and list items are equally likely, the ends included") {
    const auto odd = numbers(rolls(parameter_named("a", {3.0, 9.0, 2.0})));
    CHECK(std::set<double>(odd.begin(), odd.end()) == std::set<double>{3.0, 5.0, 7.0, 9.0});
    CHECK(std::abs(share_below(odd, 4.0) - 0.25) < spread);
    Parameter whole = parameter_named("b", {-1.0, 1.0});
    whole.type.scalar = Scalar::integer;
    const auto three = numbers(rolls(whole));
    CHECK(std::set<double>(three.begin(), three.end()) == std::set<double>{-1.0, 0.0, 1.0});
    CHECK(std::abs(share_below(three, 0.0) - 1.0 / 3.0) < spread);
    Parameter list = parameter_named("c", {0.0, 100.0});
    list.control = Control::list;
    list.items = {{0.0, "none"}, {7.0, "some"}, {50.0, "all"}};
    const auto items = numbers(rolls(list));
    CHECK(std::set<double>(items.begin(), items.end()) == std::set<double>{0.0, 7.0, 50.0});
    CHECK(std::abs(share_below(items, 50.0) - 2.0 / 3.0) < spread);
    Parameter box = parameter_named("d", {0.0, 0.0});
    box.type.scalar = Scalar::boolean;
    CHECK(std::abs(share_below(numbers(rolls(box)), 1.0) - 0.5) < spread);
}

TEST_CASE("a random colour is uniform in sRGB and keeps its alpha") {
    Parameter color = parameter_named("a", {0.0, 1.0});
    color.control = Control::color;
    color.type = {Scalar::floating, 4, 1};
    color.initial = Value(std::vector<double>{1.0, 1.0, 1.0, 0.6});
    const auto all = rolls(color);
    for (std::size_t part = 0; part < 3; ++part)
        CHECK(std::abs(share_below(numbers(all, part), 0.2140) - 0.5) < spread);  // sRGB 0.5
    CHECK(numbers(all, 3).front() == 0.6);
    CHECK(numbers(all, 3).back() == 0.6);
}

TEST_CASE("components of a random vector, angle or point are independent") {
    Parameter point = parameter_named("a", {-1.0, 1.0});
    point.control = Control::point;
    point.type = {Scalar::floating, 2, 1};
    int above = 0;
    for (const Value& value : rolls(point))
        above += value.numbers.at(0) > value.numbers.at(1) ? 1 : 0;
    CHECK(std::abs(above / 4000.0 - 0.5) < spread);
}

TEST_CASE("custom ends of a slider also limit random values") {
    const auto all =
        numbers(rolls(parameter_named("a", {0.0, 1.0}), 1000, {.ends = Limit{0.4, 0.6}}));
    CHECK(all.front() >= 0.4);
    CHECK(all.back() <= 0.6);
}

TEST_CASE(
    "randomise keeps locked and hidden parameters, events, files, the view and repeat counts") {
    Parameter hidden = parameter_named("hidden", {0.0, 1.0});
    hidden.is_hidden = true;
    Parameter event = parameter_named("event", {0.0, 1.0});
    event.control = Control::event;
    Parameter file = parameter_named("file", {0.0, 1.0});
    file.control = Control::image;
    Parameter turn = parameter_named("turn", {0.0, 1.0});
    turn.orbit = OrbitPart::turn;
    Parameter matrix = parameter_named("matrix", {0.0, 1.0});
    matrix.type = {Scalar::floating, 2, 2};
    Parameter fixed = parameter_named("fixed", {0.0, 1.0});
    fixed.is_fixed_in_random = true;
    Look look =
        look_of({fixed, parameter_named("locked", {0.0, 1.0}), parameter_named("free", {0.0, 1.0}),
                 parameter_named("samples", {1.0, 64.0}), hidden, event, file, turn, matrix});
    look.passes.resize(1);
    look.passes[0].repeat = std::string("samples");
    const Values values{{"locked", Value(0.25)}, {"orphan", Value(3.0)}};
    const ParameterSettings settings{{"locked", {.is_locked = true}}};
    const Values next = randomised_values(look, values, settings, {7});
    CHECK(next.at("locked") == Value(0.25));
    CHECK(next.at("orphan") == Value(3.0));
    CHECK(next.count("free") == 1);
    CHECK(next.size() == 3);
}

TEST_CASE("a seed gives the same values, whatever else is locked") {
    const Look look = look_of({parameter_named("a", {0.0, 1.0}), parameter_named("b", {0.0, 1.0})});
    const Values both = randomised_values(look, {}, {}, {1});
    CHECK(both == randomised_values(look, {}, {}, {1}));
    CHECK(both.at("a") != both.at("b"));
    CHECK(both.at("a") != randomised_values(look, {}, {}, {2}).at("a"));
    const Values one = randomised_values(look, {}, {{"a", {.is_locked = true}}}, {1});
    CHECK(one == Values{{"b", both.at("b")}});
}

TEST_CASE("a strength moves sliders by this share towards the random value") {
    const Look look = look_of(
        {parameter_named("a", {0.0, 4.0}), parameter_named("b", {1.0, 100.0}, Scale::logarithmic)});
    const Values start{{"a", Value(1.0)}, {"b", Value(10.0)}};
    const Values whole = randomised_values(look, start, {}, {.seed = 3});
    const Values part = randomised_values(look, start, {}, {.seed = 3, .strength = 0.25});
    CHECK(std::abs(part.at("a").number() - (0.75 + 0.25 * whole.at("a").number())) < 0.02);
    const double ratio = std::pow(whole.at("b").number() / 10.0, 0.25);
    CHECK(std::abs(part.at("b").number() / (10.0 * ratio) - 1.0) < 0.02);
}

TEST_CASE("a strength is the probability that a list or switch changes") {
    Parameter list = parameter_named("a", {0.0, 3.0});
    list.control = Control::list;
    list.items = {{0, "A"}, {1, "B"}, {2, "C"}, {3, "D"}};
    int changed = 0;
    for (std::uint64_t seed = 0; seed < 4000; ++seed)
        changed +=
            randomised_values(look_of({list}), {}, {}, {seed, 0.4}).at("a") == Value(0.0) ? 0 : 1;
    CHECK(std::abs(changed / 4000.0 - 0.4 * 0.75) < spread);  // a quarter keep the item by chance
}

TEST_CASE("names limit the change to these parameters") {
    const Look look = look_of({parameter_named("a", {0.0, 1.0}), parameter_named("b", {0.0, 1.0})});
    const Values next = randomised_values(look, {}, {}, {.seed = 1, .names = {"b"}});
    CHECK(next == Values{{"b", randomised_values(look, {}, {}, {1}).at("b")}});
}
