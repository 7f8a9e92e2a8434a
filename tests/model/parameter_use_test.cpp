#include "model/parameter_use.h"

#include <doctest/doctest.h>

TEST_CASE("a pass uses what its shaders declare, its size reads and its repeats count") {
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
    CHECK_FALSE(is_used_by(look, 1, named("crt/shri")));  // the start of another's name
    CHECK_FALSE(is_used_by(look, 1, named("shrink")));    // of another look
    CHECK(is_used_by(look, 1, named("crt/turns")));
}
