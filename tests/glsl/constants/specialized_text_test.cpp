#include "glsl/constants/specialized_text.h"

#include "glsl/compile/check.h"
#include "glsl/shader_texts.h"
#include "problems_of.h"

#include <doctest/doctest.h>

namespace {
constexpr NumberType one_float{Scalar::floating, 1, 1};

std::string specialized_float(const std::string& text) {
    return specialized_text(text, {{"gain", {one_float, Value(0.5)}}});
}
}  // namespace

TEST_CASE("a uniform declared alone becomes a variable with its value") {
    CHECK(specialized_float("uniform float gain;\n") == " float gain = 0.5;\n");
    CHECK(specialized_float("uniform float gain = 2.0;  // @range 0 4\n") ==
          " float gain = 0.5;  // @range 0 4\n");
    CHECK(specialized_float("uniform highp float gain = f(1, 2);") == " highp float gain = 0.5;");
    CHECK(specialized_float("vec2 f(float gain);\nuniform float other;\nuniform float gain;") ==
          "vec2 f(float gain);\nuniform float other;\n float gain = 0.5;");
}

TEST_CASE("specialised text keeps its line numbers") {
    CHECK(specialized_float("uniform float gain =\n  1.0 +\n  2.0;\nnext") ==
          " float gain = 0.5\n\n;\nnext");
}

TEST_CASE("every number type is written in GLSL syntax") {
    const std::string text = specialized_text(
        "uniform bool b; uniform int i; uniform uint u; uniform vec3 v; uniform ivec2 n; uniform "
        "mat2 m;",
        {{"b", {{Scalar::boolean, 1, 1}, Value(1.0)}},
         {"i", {{Scalar::integer, 1, 1}, Value(-3.0)}},
         {"u", {{Scalar::unsigned_integer, 1, 1}, Value(7.0)}},
         {"v", {{Scalar::floating, 3, 1}, Value(std::vector<double>{0.2, 1, -1e-9})}},
         {"n", {{Scalar::integer, 2, 1}, Value(std::vector<double>{10, 8})}},
         {"m", {{Scalar::floating, 2, 2}, Value(std::vector<double>{1, 2, 3, 4})}}});
    CHECK(text ==
          " bool b = true;  int i = (-3);  uint u = 7u;  vec3 v = vec3(0.2, 1.0, (-1e-09));  ivec2 "
          "n = ivec2(10, 8);  mat2 m = mat2(1.0, 2.0, 3.0, 4.0);");
}

TEST_CASE("other forms of declarations stay uniforms") {
    for (const char* text :
         {"uniform float gain, other;", "uniform float gain[2];", "uniform vec2 gain;",
          "uniform float gain = 1.0, other;", "layout(location = 0) uniform float gain;",
          "#define G uniform float gain;\n", "// uniform float gain;\n", "uniform float",
          "uniform float gain", "uniform"}) {
        CAPTURE(text);
        CHECK(specialized_float(text) == text);
    }
    const std::string text = "uniform float gain;";
    CHECK(specialized_text(text, {{"gain", {one_float, Value(1e300)}}}) == text);
    CHECK(specialized_text(text, {{"gain", {one_float, Value(std::vector<double>{})}}}) == text);
}

TEST_CASE("a block member is replaced by its value where it is read") {
    const std::map<std::string, SpecializedUniform> uniforms{
        {"push.gain", {one_float, Value(-0.5)}}};
    CHECK(specialized_text("x = push.gain * push.other + a.push.gain;", uniforms) ==
          "x = (-0.5) * push.other + a.push.gain;");
}

TEST_CASE("an out-of-bounds constant index compiles if it is not reached") {
    const std::string text =
        "#version 410 core\n"
        "uniform int tube = 1;\nout vec4 color;\n"
        "const float weights[2] = float[2](1.0, 2.0);\n"
        "void main() { color = vec4(tube == 0 ? 0.0 : weights[tube - 1]); }\n";
    Stage stage;
    stage.text = specialized_text(text, {{"tube", {{Scalar::integer, 1, 1}, Value(0.0)}}});
    Stage vertex;
    vertex.text = "#version 410 core\nvoid main() { gl_Position = vec4(0.0); }\n";
    const auto checked = check_program(vertex, stage);
    CHECK(stage.text != text);
    CHECK_MESSAGE(checked.has_value(), problems_of(checked));
}
