#include "model/plan/parameter_use.h"

#include <doctest/doctest.h>

TEST_CASE("a parameter is used by the uniforms, the size or the repeat count of a pass") {
    Look look;
    look.passes.resize(2);
    look.passes[1].scope = "crt/";
    look.passes[1].size[0] = {Side::By::expression, 1.0, "$WIDTH / $shrink"};
    look.passes[1].repeat = std::string("crt/turns");
    const auto named = [](const std::string& name, std::vector<Binding> bindings = {}) {
        Parameter parameter;
        parameter.name = name;
        parameter.bindings = std::move(bindings);
        return parameter;
    };
    const Parameter bound = named("gain", {{0, "gain"}});
    CHECK(is_used_by(look, 0, bound));
    CHECK_FALSE(is_used_by(look, 1, bound));
    CHECK(is_used_by(look, 1, named("crt/shrink")));
    CHECK_FALSE(is_used_by(look, 0, named("crt/shrink")));
    CHECK_FALSE(is_used_by(look, 1, named("crt/shri")));  // a prefix of another name
    CHECK_FALSE(is_used_by(look, 1, named("shrink")));    // of another look
    CHECK(is_used_by(look, 1, named("crt/turns")));
}

TEST_CASE("a pass is idle if a parameter makes it one texel, but not if it is always one texel") {
    Look look;
    look.passes.resize(2);
    look.passes[0].scope = "a/";
    look.passes[0].size = {Side{Side::By::expression, 1.0, "1 + $kind * $WIDTH"},
                           Side{Side::By::expression, 1.0, "1 + $kind * $HEIGHT"}};
    look.passes[1].size = {Side{Side::By::pixels, 1.0, ""}, Side{Side::By::pixels, 1.0, ""}};
    Parameter kind;
    kind.name = "a/kind";
    look.parameters = {kind};
    CHECK(is_idle(look, 0, {1, 1}));
    CHECK_FALSE(is_idle(look, 0, {1, 2}));
    CHECK_FALSE(is_idle(look, 1, {1, 1}));
}

TEST_CASE("selecting the next pass skips idle passes and wraps around") {
    Look look;
    look.passes.resize(4);
    for (const std::size_t pass : {1, 2})
        look.passes[pass].size[0] = {Side::By::expression, 1.0, "1 + $kind * $WIDTH"};
    Parameter kind;
    kind.name = "kind";
    look.parameters = {kind};
    Plan plan;
    for (const int side : {64, 1, 1, 64})
        plan.targets.push_back({.extent = {side, side}});
    CHECK(next_used_pass(look, plan, 0, 1) == 3);
    CHECK(next_used_pass(look, plan, 3, 1) == 0);
    CHECK(next_used_pass(look, plan, 0, -1) == 3);
    CHECK(next_used_pass(look, plan, 1, 1) == 3);  // from an idle pass that is displayed
    plan.targets[2].extent = {65, 64};
    CHECK(next_used_pass(look, plan, 3, -1) == 2);
}
