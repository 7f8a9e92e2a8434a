// The conditions of the looks' parameters (@when), compared with drawn pictures.
#include "lab/offline/offline.h"
#include "model/plan/condition.h"
#include "model/tuning/random_numbers.h"
#include "model/tuning/randomised.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace {
Offline started(const std::string& look) {
    auto roots = find_roots(std::filesystem::path(AFTERGLOW_SOURCE_DIR));
    REQUIRE(roots.has_value());
    RenderRequest request;
    request.look = look;
    auto prepared = prepare(request, Library(*roots));
    REQUIRE_MESSAGE(prepared.has_value(), problems_of(prepared));
    if (prepared->document.look().driven_by == Driver::signal)  // each point covers this picture
        prepared->document.amend(
            [](DocumentState& state) { state.signal.settings["points"] = 256.0; });
    auto offline = Offline::create(std::move(*prepared), {32, 24}, 30.0);
    REQUIRE_MESSAGE(offline.has_value(), problems_of(offline));
    return std::move(*offline);
}

// Random values, about half of which are an end of the slider or the identity.
Values values_for(const Look& look, std::uint64_t seed) {
    Values values = randomised_values(look, {}, {}, {seed});
    RandomNumbers random_numbers(seed + 1000);
    for (const Parameter& parameter : look.parameters) {
        const double choice = random_numbers.choose(8.0);
        const auto all = [&](double number) {
            return Value(std::vector<double>(parameter.initial.numbers.size(), number));
        };
        if (!is_randomised(look, parameter) || parameter.control == Control::color)
            continue;
        if (choice < 2.0)
            values[parameter.name] = all(parameter.range.low);
        else if (choice < 3.0)
            values[parameter.name] = all(parameter.range.high);
        else if (choice < 4.0)
            values[parameter.name] = parameter.identity.value_or(parameter.initial);
    }
    return values;
}

Picture drawn(Offline& offline, const Values& values) {
    Document document = offline.document();
    DocumentState state = document.state();
    state.values = values;
    document.change(std::move(state), "Test");
    REQUIRE(offline.start_again(std::move(document)).has_value());
    return offline.picture_after(3);
}

double largest_difference(const Picture& a, const Picture& b) {
    REQUIRE(a.pixels.size() == b.pixels.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        largest = std::max(
            largest, std::abs(static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i])));
    return largest;
}

// Draws with other values for all parameters without an effect. They must not change the picture.
// Each condition must be true for some values and false for others.
void check_conditions_of(const std::string& id) {
    constexpr std::uint64_t trials = 24;
    CAPTURE(id);
    Offline offline = started(id);
    const Look look = offline.document().look();
    std::set<std::string> with_effect;
    std::set<std::string> without_effect;
    for (std::uint64_t seed = 0; seed < trials; ++seed) {
        const Values values = values_for(look, seed);
        const Values others = values_for(look, seed + trials);
        Values changed = values;
        for (const Parameter& parameter : look.parameters) {
            if (parameter.when.empty())
                continue;
            const bool has_effect = is_condition_true(parameter, look.parameters, values);
            (has_effect ? with_effect : without_effect).insert(parameter.name);
            if (!has_effect)
                changed[parameter.name] = value_of(parameter, others);
        }
        const Picture expected = drawn(offline, values);
        const double difference = largest_difference(drawn(offline, changed), expected);
        CAPTURE(seed);
        CHECK(difference <= 1.01 / 255.0);
        if (difference <= 1.01 / 255.0)
            continue;
        for (const auto& [name, value] : changed) {
            Values single = values;
            single[name] = value;
            if (largest_difference(drawn(offline, single), expected) > 1.01 / 255.0)
                MESSAGE(name << " has an effect");
        }
    }
    for (std::uint64_t seed = 0; seed < 500; ++seed) {  // rare values, without drawing
        const Values values = values_for(look, seed);
        for (const Parameter& parameter : look.parameters)
            (is_condition_true(parameter, look.parameters, values) ? with_effect : without_effect)
                .insert(parameter.name);
    }
    for (const Parameter& parameter : look.parameters) {
        CAPTURE(parameter.name);
        CHECK((parameter.when.empty() || with_effect.contains(parameter.name)));
        CHECK((parameter.when.empty() || without_effect.contains(parameter.name)));
    }
    CHECK_FALSE(without_effect.empty());
}
}  // namespace

TEST_CASE("parameters of Phosphor whose condition is false have no effect") {
    check_conditions_of("phosphor");
}

TEST_CASE("parameters of CRT whose condition is false have no effect") {
    check_conditions_of("crt");
}

TEST_CASE("parameters of Shadow mask whose condition is false have no effect") {
    check_conditions_of("shadow-mask");
}

TEST_CASE("parameters of Vector beam whose condition is false have no effect") {
    check_conditions_of("vector-beam");
}

TEST_CASE("parameters of Caffeine whose condition is false have no effect") {
    check_conditions_of("caffeine");
}
