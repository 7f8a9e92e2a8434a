#include "model/look/value_changes.h"

#include <doctest/doctest.h>

#include <random>

namespace {
Parameter numbered(const std::string& name, double initial) {
    Parameter parameter;
    parameter.name = name;
    parameter.initial = Value(initial);
    return parameter;
}

Look look_of_three() {
    Look look;
    look.parameters = {numbered("c", 3.0), numbered("a", 1.0), numbered("b", 2.0)};
    return look;
}

using Names = std::vector<std::string>;
}  // namespace

TEST_CASE("changed parameters are listed by name, also when they return to the default") {
    const Look look = look_of_three();
    CHECK(changed_parameters(look, {}, {}).empty());
    CHECK(changed_parameters(look, {}, {{"c", Value(4.0)}, {"a", Value(2.0)}}) == Names{"a", "c"});
    CHECK(changed_parameters(look, {{"b", Value(7.0)}}, {}) == Names{"b"});
    CHECK(changed_parameters(look, {{"b", Value(7.0)}}, {{"b", Value(8.0)}}) == Names{"b"});
    CHECK(changed_parameters(look, {{"b", Value(7.0)}}, {{"b", Value(7.0)}}).empty());
}

TEST_CASE("a value equal to the default and a value without parameter are not changes") {
    const Look look = look_of_three();
    CHECK(changed_parameters(look, {}, {{"a", Value(1.0)}}).empty());
    CHECK(changed_parameters(look, {{"a", Value(1.0)}, {"b", Value(5.0)}}, {{"b", Value(5.0)}})
              .empty());
    CHECK(changed_parameters(look, {}, {{"gone", Value(1.0)}}).empty());
}

TEST_CASE("the held values are updated to equal the new ones") {
    std::mt19937 random(3);
    Values held;
    for (int turn = 0; turn < 200; ++turn) {
        Values now;
        for (int i = 0; i < 12; ++i)
            if (random() % 2 == 0)
                now["v" + std::to_string(i)] = Value(static_cast<double>(random() % 3));
        follow_values(held, now);
        CHECK(held == now);
    }
    follow_values(held, {});
    CHECK(held.empty());
}
