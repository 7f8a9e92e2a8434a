#include "formats/shadertoy_export/shadertoy_plan.h"

#include <doctest/doctest.h>

namespace {
Input from_pass(const std::string& name, int frames_ago = 0, const Sampler& sampler = {}) {
    return {"image", Input::From::pass, name, frames_ago, sampler};
}

Pass reading(const std::string& name, const Input& input) {
    Pass pass;
    pass.name = name;
    pass.inputs = {input};
    return pass;
}

// A pass that decodes the source, then passes that read the one before.
Effect chain(const std::vector<std::string>& names) {
    Effect effect;
    effect.look.passes = {reading("source", {"image", Input::From::source, "", 0, {}})};
    for (const std::string& name : names)
        effect.look.passes.push_back(reading(name, from_pass(effect.look.passes.back().name)));
    effect.source_pass = "source";
    return effect;
}

std::string refusal(const Effect& effect) {
    return shadertoy_obstacle(shadertoy_plan(effect), {64, 32}, {64, 32});
}
}  // namespace

TEST_CASE("passes get buffers in order, except the last one and the one that decodes the source") {
    const Effect effect = chain({"a", "b", "shown"});
    CHECK(shadertoy_plan(effect).buffers == std::map<std::string, int>{{"a", 0}, {"b", 1}});
    CHECK_FALSE(shadertoy_plan(effect).has_levels);
    CHECK(refusal(effect).empty());
}

TEST_CASE("mip levels of linear light are in Buffer A, those of display values in the channel") {
    Effect effect = chain({"a", "shown"});
    effect.look.passes[1].inputs[0].sampler.mipmap = true;
    effect.look.source_encoding = Encoding::linear;
    CHECK(shadertoy_plan(effect).has_levels);
    CHECK(shadertoy_plan(effect).buffers == std::map<std::string, int>{{"a", 1}});
    effect.look.source_encoding = Encoding::display;
    CHECK_FALSE(shadertoy_plan(effect).has_levels);
}

TEST_CASE("a beam has a table in Buffer A, and passes are drawn where they are read if they must") {
    Effect effect = chain({"beam", "a", "b", "c", "shown"});
    effect.look.passes.erase(effect.look.passes.begin());
    effect.source_pass.clear();
    effect.look.passes[0].inputs.clear();
    effect.look.passes[1].inputs.push_back(from_pass("a", 1));
    const ShadertoyPlan small = shadertoy_plan(effect, "beam");
    CHECK(small.inlined == std::set<std::string>{"beam"});
    CHECK(small.buffers == std::map<std::string, int>{{"a", 1}, {"b", 2}, {"c", 3}});
    effect.look.passes.insert(effect.look.passes.end() - 1, reading("d", from_pass("c")));
    effect.look.passes.back().inputs = {from_pass("d")};
    const ShadertoyPlan large = shadertoy_plan(effect, "beam");  // "a" reads its past
    CHECK(large.inlined == std::set<std::string>{"b", "beam"});
    CHECK(large.buffers == std::map<std::string, int>{{"a", 1}, {"c", 2}, {"d", 3}});
    CHECK(shadertoy_obstacle(large, {64, 32}, {64, 32}).empty());
}

TEST_CASE("more than four buffers are refused with their number") {
    CHECK(refusal(chain({"a", "b", "c", "d", "shown"})).empty());
    Effect effect = chain({"a", "b", "c", "d", "shown"});
    effect.look.passes[1].inputs[0].sampler.mipmap = true;
    CHECK(refusal(effect) ==
          "the look needs 5 buffers, one for mip levels of the source. Shadertoy has four and the "
          "image. Export it with --to web.");
}

TEST_CASE("a pass can read the previous picture of itself and of later buffers") {
    Effect effect = chain({"a", "b", "shown"});
    effect.look.passes[1].inputs = {from_pass("b", 1)};
    CHECK(refusal(effect).empty());
    effect.look.passes[1].inputs = {from_pass("a", 1)};
    CHECK(refusal(effect).empty());
    effect.look.passes[2].inputs = {from_pass("a", 1)};
    CHECK(refusal(effect).find("reads what an earlier pass drew") != std::string::npos);
    effect.look.passes[2].inputs = {from_pass("shown", 1)};
    CHECK(refusal(effect).find("reads the last pass") != std::string::npos);
}

TEST_CASE("passes larger than the picture and mip levels of smaller ones are refused") {
    Effect effect = chain({"a", "shown"});
    effect.look.passes[1].size[0].factor = 2.0;
    CHECK(refusal(effect).find("is larger than the picture") != std::string::npos);
    effect.look.passes[1].size[0] = {Side::By::pixels, 65.0, {}};
    CHECK(refusal(effect).find("is larger than the picture") != std::string::npos);
    effect.look.passes[1].size[0] = {Side::By::pixels, 64.0, {}};
    CHECK(refusal(effect).empty());
    effect.look.passes[2].inputs[0].sampler.mipmap = true;
    CHECK(refusal(effect).find("reads mip levels of 'a'") != std::string::npos);
}
