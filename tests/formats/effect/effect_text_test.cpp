#include "formats/effect/effect_text.h"

#include <doctest/doctest.h>

TEST_CASE("declared uniforms become comments, and other text stays in place") {
    const std::string text =
        "#version 410 core\n#pragma once\n// Gain.\nuniform float gain = 1.0;  // @range 0 2\n"
        "in vec2 uv;\nout vec4 color;\nvoid main() { color = vec4(gain); }\n";
    CHECK(effect_text(text, {.declared = {"gain"},
                             .input = "layout(location = 0) in",
                             .output = "layout(location = 0) out"}) ==
          "\n\n// Gain.\n/* uniform float gain = 1.0; */  // @range 0 2\n"
          "layout(location = 0) in vec2 uv;\nlayout(location = 0) out vec4 color;\n"
          "void main() { color = vec4(gain); }\n");
}

TEST_CASE("a comment inside a declaration does not end the comment around it") {
    CHECK(effect_text("uniform /* why */\nfloat gain;\nint a;\n", {.declared = {"gain"}}) ==
          "\n\nint a;\n");
}

TEST_CASE("other uniforms become variables with a value") {
    CHECK(effect_text("uniform float a, b = 2.0;\n", {.declared = {"a"}}) == "float b = 2.0;\n");
    CHECK(effect_text("uniform vec2 a;\n", {}) == "vec2 a = vec2(0);\n");
    CHECK(effect_text("uniform S s;\n", {.values = {{"s", "1.0, gain"}}}) ==
          "S s = S(1.0, gain);\n");
}

TEST_CASE("uniforms can become constants at their place, and keep their comments") {
    CHECK(effect_text("uniform sampler2D a;  // @label \"A\"\nuniform float b = 2.0, c;\n",
                      {.constants = {{"a", {"int", "3"}}, {"c", {"float", "0.5"}}},
                       .words = {{"a", "own_a"}}}) ==
          "const int own_a = 3;  // @label \"A\"\nfloat b = 2.0; const float c = 0.5;\n");
}

TEST_CASE("words are renamed in code and directives, not in comments or given values") {
    CHECK(effect_text("#define A main\nvoid main() {}  // main\nuniform S s;\n",
                      {.values = {{"s", "main"}}, .words = {{"main", "draw"}, {"S", "T"}}}) ==
          "#define A draw\nvoid draw() {}  // main\nT s = T(main);\n");
}

TEST_CASE("components of vectors and members with their names are not renamed") {
    CHECK(effect_text(
              "struct S { float r; float gain; };\nbool r; vec4 a = vec4(r), b = a.r + s.gain;\n",
              {.words = {{"r", "own_r"}, {"gain", "own_gain"}}}) ==
          "struct S { float r; float own_gain; };\n"
          "bool own_r; vec4 a = vec4(own_r), b = a.r + s.own_gain;\n");
}

TEST_CASE("inputs and outputs without qualifiers are variables") {
    CHECK(effect_text("layout(location = 1) flat in int n;\nout vec4 color;\n", {}) ==
          "int n;\nvec4 color;\n");
}

TEST_CASE("names of GLSL's functions get others") {
    CHECK(renamed_built_ins("float distance(vec2 a, vec2 b) { return 1.0; }\nfloat mine;\n") ==
          WordChanges{{"distance", "own_distance"}});
}

TEST_CASE("extensions are listed once") {
    CHECK(
        extension_lines("#extension A : enable\n#extension B : require\n#extension A : enable\n") ==
        std::vector<std::string>{"#extension A : enable", "#extension B : require"});
}
