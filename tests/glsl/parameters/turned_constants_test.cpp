#include "glsl/parameters/constant_parameters.h"
#include "glsl/shader_texts.h"

#include <doctest/doctest.h>

namespace {
Look look_of_texts(const std::string& first, const std::string& second = "") {
    Look look;
    look.passes = {pass_of("one", fragment_with(first, "one.frag")),
                   pass_of("two", fragment_with(second, "two.frag"))};
    return look;
}

std::string mistakes_of(Look look) {
    return to_string(write_constants(look, nullptr));
}
}  // namespace

TEST_CASE("a constant is a parameter whose default is the written number") {
    Look look = look_of_texts(
        "#define STEPS 64  // @range 8 256 2 @label \"Steps\" @unit \"x\" @group \"Rays\" @help "
        "\"How many.\"\n");
    REQUIRE(write_constants(look, nullptr).empty());
    REQUIRE(look.parameters.size() == 1);
    const Parameter& steps = look.parameters.front();
    CHECK(steps.name == "STEPS");
    CHECK(steps.is_constant);
    CHECK(steps.type == NumberType{Scalar::integer, 1, 1});
    CHECK(steps.initial == Value(64.0));
    CHECK(steps.range == Range{8.0, 256.0, 2.0});
    CHECK(steps.label == "Steps");
    CHECK(steps.unit == "x");
    CHECK(steps.group == "Rays");
    CHECK(steps.help == "How many.");
    CHECK(steps.bindings == std::vector<Binding>{{0, "STEPS"}});
    CHECK(look.constants == Values{{"STEPS", 64.0}});
}

TEST_CASE("a constant in capitals gets a readable label") {
    Look look =
        look_of_texts("#define MAX_STEPS 3  // @range 1 9\n#define softNess 0.5  // @range 0 1\n");
    REQUIRE(write_constants(look, nullptr).empty());
    CHECK(look.parameters[0].label == "Max steps");
    CHECK(look.parameters[1].label == "SoftNess");
}

TEST_CASE("a value replaces the written number, and no line moves") {
    const std::string before = "#ifndef N\n#define N 3  // @range 1 9\n#endif\n#undef M\n";
    Look look = look_of_texts(before + "const float A = 0.5, B = 1.0;  // @range -1 1\n", before);
    const Look plain = look;
    const Values values{{"N", 5.0}, {"A", -0.25}, {"other", 9.0}};
    REQUIRE(write_constants(look, &values).empty());
    const auto with = [](std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    };
    const std::string& first = plain.passes[0].fragment.text;
    CHECK(look.passes[0].fragment.text ==
          with(with(first, "N 3", "N 5"), "A = 0.5", "A = (-0.25)"));
    CHECK(look.passes[0].fragment.lines == plain.passes[0].fragment.lines);
    CHECK(look.passes[1].fragment.text == with(plain.passes[1].fragment.text, "N 3", "N 5"));
    CHECK(look.constants == Values{{"N", 5.0}, {"A", -0.25}, {"B", 1.0}});
    CHECK(find_parameter(look, "N")->bindings == std::vector<Binding>{{0, "N"}, {1, "N"}});
    CHECK(find_parameter(look, "N")->initial == Value(3.0));
}

TEST_CASE("a value is converted to the constant's type, and found under its previous name") {
    Look look =
        look_of_texts("#define N 3  // @range 1 9 @was COUNT\n#define ON false // @label \"On\"\n");
    const Values values{{"COUNT", 6.6}, {"ON", 3.0}};
    REQUIRE(write_constants(look, &values).empty());
    CHECK(look.constants == Values{{"N", 7.0}, {"ON", 1.0}});
}

TEST_CASE("errors in annotations of constants are reported like those of uniforms") {
    CHECK(mistakes_of(look_of_texts("#define N 3  // @range 9 1\n")) ==
          "one.frag:2: error: @range: the minimum must be below the maximum, got 9 and 1\n");
    CHECK(mistakes_of(look_of_texts("#define N 3  // @range 0.5 9\n")) ==
          "one.frag:2: error: @range: 0.5 is not a valid int\n");
    CHECK(mistakes_of(look_of_texts("#define N 3  // @range 4 9 @limit 4 9\n")) ==
          "one.frag:2: error: the default 3 is outside @limit\n");
    CHECK(mistakes_of(look_of_texts("#define N 3  // @range 1 9 @lable \"N\"\n")) ==
          "one.frag:2: error: unknown annotation '@lable' (did you mean '@label'?)\n");
    CHECK(mistakes_of(look_of_texts("#define N true  // @range 0 1\n")) ==
          "one.frag:2: error: @range is only for numbers; 'N' is a bool\n");
    CHECK(mistakes_of(look_of_texts("const vec3 C = vec3(1.0);  // @range 0 1\n")) ==
          "one.frag:2: error: @range and @items are only for constants with one plain number; 'C' "
          "has another value\n");
}

TEST_CASE("a constant with conflicting definitions is an error at the second one") {
    CHECK(
        mistakes_of(
            look_of_texts("#define N 3  // @range 1 9\n", "#define N 4  // @range 1 9\n")) ==
        "two.frag:2: error: 'N' is 4 here but 3 elsewhere (at one.frag:2); an adjustable constant "
        "needs the same value everywhere\n");
    CHECK(
        mistakes_of(look_of_texts("#define N 3  // @range 1 9\n", "#define N 3.0  // @range 1 9\n"))
            .starts_with("two.frag:2: error: 'N' is 3.0 here but 3 elsewhere"));
    CHECK(mistakes_of(look_of_texts("#define N 3  // @range 1 9\n", "#define N 4\n")).empty());
    CHECK(mistakes_of(
              look_of_texts("#define N 3  // @range 1 9\n", "#define N 3  // @range 1 8\n")) ==
          "two.frag:2: error: @range of 'N' differs from another declaration (at "
          "one.frag:2)\n");
}
