#include "model/look/look.h"

#include <doctest/doctest.h>

namespace {
Look look_with(const std::vector<std::pair<std::string, Value>>& defaults) {
    Look look;
    for (const auto& [name, initial] : defaults) {
        Parameter parameter;
        parameter.name = name;
        parameter.initial = initial;
        look.parameters.push_back(parameter);
    }
    return look;
}
}  // namespace

TEST_CASE("the reference of an input is written as in look.json") {
    CHECK(Input{"p", Input::From::pass, "persistence", 1, {}}.reference() == "persistence@1");
    CHECK(Input{"p", Input::From::pass, "beam", 0, {}}.reference() == "beam");
    CHECK(Input{"p", Input::From::source, "", 2, {}}.reference() == "source@2");
}

TEST_CASE("the value of a parameter is the set value, else the default") {
    const Look look = look_with({{"decay", 0.9}});
    CHECK(value_of(look.parameters[0], {{"decay", 0.5}}) == Value(0.5));
    CHECK(value_of(look.parameters[0], {{"other", 0.5}}) == Value(0.9));
}

TEST_CASE("values equal to their default are not changes; orphaned values stay") {
    const Look look = look_with({{"decay", 0.9}, {"gain", 1.0}});
    const Values values{{"decay", 0.9}, {"gain", 2.0}, {"gone", 3.0}};
    CHECK(changed_values(look, values) == Values{{"gain", 2.0}, {"gone", 3.0}});
    CHECK(orphans(look, values) == std::vector<std::string>{"gone"});
}

TEST_CASE("a renamed parameter keeps its value, unless the old name is still in use") {
    Look look = look_with({{"fade", 0.9}});
    look.parameters[0].was = "decay";
    CHECK(renamed_values(look, {{"decay", 0.5}}) == Values{{"fade", 0.5}});
    CHECK(renamed_values(look, {{"decay", 0.5}, {"fade", 0.7}}) ==
          Values{{"decay", 0.5}, {"fade", 0.7}});
    look.parameters.push_back(look_with({{"decay", 0.1}}).parameters[0]);
    CHECK(renamed_values(look, {{"decay", 0.5}}) == Values{{"decay", 0.5}});
}

TEST_CASE("the digest depends on names and defaults, but not on their order") {
    const std::string digest = look_digest(look_with({{"a", 1.0}, {"b", 2.0}}));
    CHECK(digest.size() == 6);  // three characters per parameter
    CHECK(look_digest(look_with({{"b", 2.0}, {"a", 1.0}})) == digest);
    CHECK(look_digest(look_with({{"a", 1.0}, {"b", 2.5}})) != digest);
    CHECK(look_digest(look_with({{"a", 1.0}, {"c", 2.0}})) != digest);
}

TEST_CASE("passes and parameters are found by exact name") {
    Look look = look_with({{"decay", 0.9}});
    look.passes.resize(2);
    look.passes[1].name = "bloom";
    CHECK(find_pass(look, "bloom") == 1);
    CHECK_FALSE(find_pass(look, "glow").has_value());
    CHECK(find_parameter(look, "decay") == look.parameters.data());
    CHECK(find_parameter(look, "glow") == nullptr);
}
