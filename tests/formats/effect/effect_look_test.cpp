#include "formats/effect/effect_look.h"

#include "formats/effect/effect_controls.h"
#include "formats/effect/effect_names.h"
#include "glsl/text/include.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
constexpr EffectHost host{.name = "Host", .samples_per_texture = true};

Pass reading(const std::string& name, const Input& input) {
    Pass pass;
    pass.name = name;
    pass.vertex = fullscreen_vertex_stage();
    pass.fragment = builtin_stage("#version 410 core\nvoid main() {}\n");
    pass.inputs = {input};
    return pass;
}

Look chain() {
    Look look;
    look.driven_by = Driver::picture;
    look.passes = {reading("first pass", {"a", Input::From::source, "", 0, {}}),
                   reading("last", {"b", Input::From::pass, "first pass", 0, {}})};
    return look;
}

std::vector<std::string> names_of(const Look& look) {
    return pass_names(look);
}

std::string refusal(const Look& look) {
    const auto effect = effect_of(look, {}, {64, 32}, {32, 16}, host);
    return effect ? "" : effect.error().front().message;
}
}  // namespace

TEST_CASE("only the first pass reads the source, and only the last has the host's rows") {
    const auto effect = effect_of(chain(), {}, {64, 32}, {32, 16}, host);
    REQUIRE(effect.has_value());
    CHECK(names_of(effect->look) ==
          std::vector<std::string>{"source", "first_pass", "last", "screen"});
    CHECK(effect->look.passes[1].inputs[0].name == "source");
    CHECK(effect->look.passes[2].inputs[0].name == "first_pass");
}

TEST_CASE("a host that turns the last pass itself gets no pass for that") {
    EffectHost turning = host;
    turning.turns_last_pass = true;
    const auto effect = effect_of(chain(), {}, {64, 32}, {32, 16}, turning);
    REQUIRE(effect.has_value());
    CHECK(names_of(effect->look) == std::vector<std::string>{"source", "first_pass", "last"});
    CHECK(effect->look.passes.back().rows == RowOrder::bottom_first);
}

TEST_CASE("values that a host does not give are listed as losses") {
    Look look = chain();
    look.passes[0].built_ins = {{"iMouse", BuiltIn::press}, {"iDate", BuiltIn::date}};
    look.passes[0].fragment = builtin_stage(
        "#version 410 core\nuniform vec4 iMouse;\nuniform vec4 iDate;\nout vec4 color;\n"
        "void main() { color = iMouse + iDate; }\n");
    EffectHost bare = host;
    bare.has_date = false;
    const auto lost = effect_of(look, {}, {64, 32}, {32, 16}, bare);
    REQUIRE(lost.has_value());
    CHECK(lost->losses == std::vector<std::string>{"The mouse. Its position is always 0.",
                                                   "The date. It is always 0."});
    EffectHost rich = host;
    rich.has_mouse = true;
    const auto kept = effect_of(look, {}, {64, 32}, {32, 16}, rich);
    REQUIRE(kept.has_value());
    CHECK(kept->losses.empty());
    look.passes[0].fragment = builtin_stage("#version 410 core\nuniform vec4 iMouse;\n");
    const auto unused = effect_of(look, {}, {64, 32}, {32, 16}, bare);
    REQUIRE(unused.has_value());
    CHECK(unused->losses.empty());
}

TEST_CASE("a texture with two samplers gets a copy for the second") {
    Look look = chain();
    look.passes.insert(
        look.passes.begin() + 1,
        reading("wide", {"b", Input::From::pass, "first pass", 0, {.wrap = Wrap::border}}));
    const auto effect = effect_of(look, {}, {64, 32}, {32, 16}, host);
    REQUIRE(effect.has_value());
    CHECK(names_of(effect->look) == std::vector<std::string>{"source", "first_pass", "first_pass_2",
                                                             "wide", "last", "screen"});
    CHECK(effect->look.passes[3].inputs[0].name == "first_pass");
    CHECK(effect->look.passes[4].inputs[0].name == "first_pass_2");
}

TEST_CASE("a previous picture is copied for later passes if the host does not keep it") {
    Look look = chain();
    look.passes[0].inputs.push_back({"before", Input::From::pass, "first pass", 1, {}});
    look.passes[1].inputs.push_back({"before", Input::From::pass, "first pass", 1, {}});
    constexpr EffectHost forgetful{.name = "Host", .keeps_previous = false};
    const auto effect = effect_of(look, {}, {64, 32}, {32, 16}, forgetful);
    REQUIRE(effect.has_value());
    const std::vector<Pass>& passes = effect->look.passes;
    CHECK(names_of(effect->look) ==
          std::vector<std::string>{"source", "first_pass_2", "first_pass", "last", "screen"});
    CHECK(passes[1].inputs[0].reference() == "first_pass@1");  // before it is drawn again
    CHECK(passes[2].inputs[1].reference() == "first_pass@1");
    CHECK(passes[3].inputs[0].reference() == "first_pass");
    CHECK(passes[3].inputs[1].reference() == "first_pass_2");
}

TEST_CASE("sizes by expressions become a part of the viewport or a number of pixels") {
    Look look = chain();
    look.passes[0].size = {Side{Side::By::expression, 1.0, "$WIDTH / 4"},
                           Side{Side::By::expression, 1.0, "7"}};
    const auto effect = effect_of(look, {}, {64, 32}, {32, 16}, host);
    REQUIRE(effect.has_value());
    CHECK(effect->look.passes[1].size[0] == Side{Side::By::viewport, 0.25, {}});
    CHECK(effect->look.passes[1].size[1] == Side{Side::By::pixels, 7.0, {}});
}

TEST_CASE("what a host can't draw is refused with the pass, the reason and an alternative") {
    Look look = chain();
    look.passes[0].draw = Draw::points;
    CHECK(
        refusal(look) ==
        "the pass 'first pass' draws a beam, which Host can't do. Export it with --to web or --to "
        "portable.");
    look.has_other_driver = true;
    CHECK(refusal(look) ==
          "a beam draws a signal, which Host can't do. Use a source picture (--source or a preset "
          "with one), --to web or --to portable.");
    look = chain();
    look.passes[0].accumulate = true;
    CHECK(refusal(look).find("accumulates samples") != std::string::npos);
    look = chain();
    look.passes[1].inputs[0].frames_ago = 2;
    CHECK(refusal(look).find("more than one frame ago") != std::string::npos);
}

TEST_CASE("a picture that is not chosen is not read, and a chosen one is fixed") {
    Look look = chain();
    look.passes[0].inputs.push_back({"lut", Input::From::image, "lut", 0, {}});
    Parameter lut;
    lut.name = lut.label = "lut";
    lut.control = Control::image;
    lut.bindings = {{0, "lut"}};
    look.parameters = {lut};
    const auto without = effect_of(look, {}, {64, 32}, {32, 16}, host);
    REQUIRE(without.has_value());
    CHECK(without->look.passes[1].inputs.size() == 1);
    CHECK(without->look.images.empty());
    const Values values{{"lut", Value::of_path("pattern:ramp")}};
    const auto with = effect_of(look, values, {64, 32}, {32, 16}, host);
    REQUIRE(with.has_value());
    REQUIRE(with->look.images.size() == 1);
    CHECK(with->look.images[0].made == "pattern:ramp");
    CHECK(with->look.passes[1].inputs[1].name == with->look.images[0].name);
    CHECK(with->losses == std::vector<std::string>{"The control 'lut'. Its picture is fixed."});
}

TEST_CASE("names are identifiers, each once") {
    EffectNames names({"taken"});
    CHECK(names.add("crt/mask size") == "crt_mask_size");
    CHECK(names.add("crt_mask-size") == "crt_mask_size_2");
    CHECK(names.add("taken") == "taken_2");
    CHECK(identifier_from("2 x__y") == "p_2_x_y");
    CHECK(identifier_from("gl_Position") == "p_gl_Position");
    CHECK(identifier_from("*/") == "p_");
}

TEST_CASE("text for quoted strings has no quotes, line ends or backslashes") {
    CHECK(quotable("a \"b\"\n\\ */") == "a 'b'   */");
}
