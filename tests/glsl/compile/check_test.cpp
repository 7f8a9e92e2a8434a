#include "glsl/compile/check.h"

#include "glsl/cache/check_cache.h"
#include "glsl/shader_texts.h"
#include "in_a_moment.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <thread>

namespace {
Result<Reflection> check(const Stage& fragment) {
    return check_program(fullscreen_vertex_stage(), fragment);
}

std::string first_error(const Stage& fragment) {
    const auto reflection = check(fragment);
    REQUIRE_FALSE(reflection.has_value());
    return to_string(reflection.error().front());
}

Uniform uniform_of(const std::string& declaration) {
    const auto reflection = check(fragment_with(declaration));
    if (!reflection)
        FAIL(to_string(reflection.error()));
    REQUIRE(reflection->uniforms.size() == 1);
    return reflection->uniforms.front();
}
}  // namespace

TEST_CASE("an error of glslang is cleaned up and located in the original file") {
    CHECK(first_error(stage_of(
              "a.frag", "#version 410 core\nout vec4 c;\nvoid main() {\n  c = vec4(foo);\n}\n")) ==
          "a.frag:4: error: 'foo' is undeclared");
    CHECK(first_error(stage_of(
              "a.frag", "#version 410 core\nout vec4 c;\nvoid main() {\n  c = vec4(1)\n}\n")) ==
          "a.frag:5: error: syntax error, unexpected '}', expecting ',' or ';'");
    const auto one = check(fragment_with("float a = b;"));
    REQUIRE_FALSE(one.has_value());
    CHECK(one.error().size() == 1);
}

TEST_CASE("a quoted text is reported as an invalid string, not as an extension") {
    CHECK(first_error(
              stage_of("a.frag", "#version 410 core\nvoid main() {\n  int x = \"x\";\n}\n")) ==
          "a.frag:3: error: GLSL has no strings");
}

TEST_CASE("errors of both stages are reported together") {
    const auto reflection =
        check_program(stage_of("a.vert", "#version 410 core\nvoid main() { gl_Position = up; }\n"),
                      stage_of("a.frag", "#version 410 core\n\nvoid main() { left; }\n"));
    REQUIRE_FALSE(reflection.has_value());
    CAPTURE(to_string(reflection.error()));
    REQUIRE(reflection.error().size() == 2);
    CHECK(to_string(reflection.error()[0]) == "a.vert:2: error: 'up' is undeclared");
    CHECK(to_string(reflection.error()[1]) == "a.frag:3: error: 'left' is undeclared");
}

TEST_CASE("#line directives do not change reported lines") {
    CHECK(first_error(stage_of("a.frag", "#version 410 core\n#line 900 7\nfloat a = b;\n")) ==
          "a.frag:3: error: 'b' is undeclared");
}

TEST_CASE("a missing or wrong #version gives a specific error") {
    CHECK(first_error(stage_of("a.frag", "// hello\n\nvoid main() {}\n")) ==
          "a.frag:3: error: the shader's first line must be '#version 410 core'");
    CHECK(first_error(stage_of("a.frag", "")).find("the shader is empty") != std::string::npos);
    CHECK(first_error(stage_of("a.frag", "#version 300 es\nvoid main() {}\n"))
              .starts_with("a.frag:1:"));
    CHECK(
        first_error(stage_of("a.frag", "#version 120\nvoid main() {}\n")).starts_with("a.frag:1:"));
    CHECK(
        check(stage_of("a.frag", "/* a\n */\n\n#version 410 core\nvoid main() {}\n")).has_value());
    CHECK(check(stage_of("a.frag", "#version 330\nvoid main() {}\n")).has_value());
}

TEST_CASE("mismatches between stages are reported in the fragment shader") {
    const Stage vertex =
        stage_of("a.vert",
                 "#version 410 core\n"
                 "uniform float gain = 1.0;\n"
                 "uniform float power = 1.0;\n"
                 "out vec2 uv;\n"
                 "void main() { uv = vec2(gain + power); gl_Position = vec4(1); }\n");
    const auto reflection =
        check_program(vertex, stage_of("a.frag",
                                       "#version 410 core\n"
                                       "in vec3 uv;\n"
                                       "in float glow;\n"
                                       "in float unused;\n"
                                       "uniform vec2 gain;\n"
                                       "uniform float power = 2.0;\n"
                                       "out vec4 c;\n"
                                       "void main() { c = vec4(uv, glow); }\n"));
    REQUIRE_FALSE(reflection.has_value());
    CHECK(to_string(reflection.error()) ==
          "a.frag:5: error: 'gain' is a vec2 here but a float in the vertex shader (at a.vert:2)\n"
          "a.frag:6: error: 'power' is 2 here but 1 in the vertex shader (at a.vert:3)\n"
          "a.frag:2: error: 'uv' is a vec3 here but a vec2 in the vertex shader\n"
          "a.frag:3: error: the vertex shader has no 'out float glow'\n");
}

TEST_CASE("link errors have a line") {
    CHECK(first_error(stage_of("a.frag", "#version 410 core\nfloat f;\n")) ==
          "a.frag:1: error: the shader has no main()");
    CHECK(first_error(stage_of("a.frag",
                               "#version 410 core\n\nfloat f(float x);\nvoid main() { f(1.0); }\n"))
              .starts_with("a.frag:3: error: No function definition (body) found: f()"));
    CHECK(first_error(stage_of("a.frag",
                               "#version 410 core\nfloat f(float x) { return f(x); }\n"
                               "void main() { f(1.0); }\n"))
              .starts_with("a.frag:2: error: Recursion detected: f() calling f()"));
}

TEST_CASE("defaults of every number type are read as written") {
    CHECK(uniform_of("uniform float a = 0.92;").initial == Value(0.92));
    CHECK(uniform_of("uniform float a = 3;").initial == Value(3.0));
    CHECK(uniform_of("uniform vec3 a = vec3(0.2, 1, 0.3);").initial == Value({0.2, 1.0, 0.3}));
    CHECK(uniform_of("uniform vec2 a = vec2(0.2) * 2.0;").initial == Value({0.4, 0.4}));
    CHECK(uniform_of("uniform float a = 0.1 * 3.0;").initial == Value(0.3));
    CHECK(uniform_of("#define K 0.5\nuniform float a = K * 3;").initial == Value(1.5));
    CHECK(uniform_of("const vec2 k = vec2(7, 8);\nuniform float a = k.y;").initial == Value(8.0));
    CHECK(uniform_of("uniform int a = -3;").initial == Value(-3.0));
    CHECK(uniform_of("uniform ivec2 a = ivec2(1, -2);").initial == Value({1.0, -2.0}));
    CHECK(uniform_of("uniform uvec2 a = uvec2(1, 4000000000u);").initial == Value({1.0, 4e9}));
    CHECK(uniform_of("uniform bool a = true;").initial == Value(1.0));
    CHECK(uniform_of("uniform bvec2 a = bvec2(true, false);").initial == Value({1.0, 0.0}));
    CHECK(uniform_of("uniform mat2 a = mat2(3.0);").initial == Value({3.0, 0.0, 0.0, 3.0}));
    CHECK(uniform_of("uniform mat2x3 a = mat2x3(1, 2, 3, 4, 5, 6);").initial ==
          Value({1.0, 2.0, 3.0, 4.0, 5.0, 6.0}));
    CHECK_FALSE(uniform_of("uniform float a;").initial.has_value());
}

TEST_CASE("a default outside the float range is an error on its line") {
    for (const std::string number : {"1e39", "1.0 / 0.0", "0.0 / 0.0"})
        CHECK(first_error(fragment_with("uniform float a = " + number + ";")) ==
              "a.frag:2: error: the default of 'a' is not a finite 32-bit number");
}

TEST_CASE("types have GLSL names, and unsupported types give a reason") {
    const Uniform matrix = uniform_of("uniform mat2x3 a;");
    CHECK(matrix.type == NumberType{Scalar::floating, 3, 2});
    CHECK(matrix.type_name == "mat2x3");
    CHECK(uniform_of("uniform sampler2D a;").kind == Uniform::Kind::sampler);
    CHECK(uniform_of("uniform usampler3D a;").type_name == "usampler3D");
    for (const auto& row :
         {std::pair{"uniform float a[3];", "float[3]"}, std::pair{"uniform double a;", "double"},
          std::pair{"uniform dvec2 a;", "dvec2"},
          std::pair{"uniform struct S { float x; } a;", "struct S"},
          std::pair{"uniform a { float x; };", "block a"},
          std::pair{"uniform sampler2D a[2];", "sampler2D[2]"}}) {
        CAPTURE(row.first);
        const Uniform uniform = uniform_of(row.first);
        CHECK(uniform.name == "a");
        CHECK(uniform.kind == Uniform::Kind::other);
        CHECK(uniform.type_name == row.second);
        CHECK(uniform.why_no_control.starts_with("'a' (" + std::string(row.second) + ") is "));
        CHECK(uniform.declared == std::vector<Location>{{"a.frag", 2}});
    }
}

TEST_CASE("a uniform is located in its active branch, also from a macro") {
    CHECK(uniform_of("#if 0\nuniform float a;\n#else\nuniform float a;\n#endif")
              .declared.front()
              .line == 5);
    CHECK(uniform_of("#define P(n) uniform float n\n\nP(a);").declared.front().line == 4);
}

TEST_CASE("an error in a generated line is reported for the author's file") {
    Stage stage = stage_of("a.frag", "#version 410 core\nnothing here;\nvoid main() {}\n");
    stage.lines = {{{}, 1}, {{}, 1}, {"a.frag", 1}};
    CHECK(first_error(stage).starts_with("a.frag: error: "));
}

TEST_CASE("shaders that would overflow the compiler's stack are rejected with a line") {
    const std::string open = "void main() {\nfloat x = ";
    for (const std::string& text : {
             open + times(5000, "(") + "1.0" + times(5000, ")") + ";}",
             open + "1.0" + times(200000, "+1.0") + ";}",
             "void main() {\nvec2 v = vec2(1.0); v = v" + times(200000, ".xy") + ";}",
             "\n#if " + times(200000, "!") + "1\n#endif\nvoid main() {}",
             "\n#if " + times(200000, "(") + "1\n#endif\nvoid main() {}",
             open + times(200000, "- ") + "1.0;}",
             open + "(1.0" + times(20000, ", 1.0") + ");}",
             open + "sin(1.0" + times(8000, "+1.0") + times(200, "+sin(1.0, 1.0") +
                 times(20000, "+1.0") + times(201, ")") + ";}",
             "#define C )+(\nvoid main() { float x = sin(1.0 C 1.0" + times(20000, ", 1.0") + ");}",
             "void main() {\n" + times(100000, "{") + times(100000, "}") + "}",
         }) {
        const std::string message = first_error(stage_of("a.frag", "#version 410 core\n" + text));
        CHECK(message.starts_with("a.frag:3: error:"));
    }
}

TEST_CASE("exponentially growing macros are rejected before expansion") {
    std::string plain = "#version 410 core\n#define M0 1.0\n";
    for (int i = 0; i < 40; ++i) {
        plain += fmt::format("#define M{} M{}+M{}\n", i + 1, i, i);
    }
    CHECK(first_error(stage_of("a.frag", plain + "float x = M40;\nvoid main() {}\n"))
              .starts_with(
                  "a.frag:43: error: this statement has more tokens than the limit of 16384"));
    CHECK(check(stage_of("a.frag", plain + "float x = M5;\nvoid main() {}\n")).has_value());

    const std::string call = "#version 410 core\n#define F(x) x + x\n#define G(f, x) f(x)\n";
    const std::string nested = "float x = " + times(60, "F(") + "1.0" + times(60, ")") + ";\n";
    CHECK(first_error(stage_of("a.frag", call + nested))
              .starts_with("a.frag:4: error: this statement has more tokens"));
    const std::string by_name = "float x = " + times(60, "G(F, ") + "1.0" + times(60, ")") + ";\n";
    CHECK(first_error(stage_of("a.frag", call + by_name))
              .starts_with("a.frag:4: error: this statement has more tokens"));
    CHECK(
        check(stage_of("a.frag", call + "float x = G(F, F(1.0));\nvoid main() {}\n")).has_value());
}

TEST_CASE("long array initialisers do not count as nesting") {
    const std::string table =
        "#define V(x) vec2(x, -x)\n#define TWO 2.0\nconst vec2 m[5001] = vec2[](" +
        times(5000, "V(TWO), ") +
        "vec2(1, TWO));\n"
        "const int t[20001] = int[](" +
        times(20000, "5, ") +
        "5);\n"
        "const vec2 v[8001] = vec2[](" +
        times(8000, "vec2(1, -2), ") + "vec2(0));\n";
    CHECK(
        check(stage_of("a.frag", "#version 410 core\n" + table + "void main() {}\n")).has_value());
}

TEST_CASE("a long but flat shader is accepted") {
    const std::string table = "const float t[6000] = float[](" + times(5999, "0.5, ") + "0.5);\n";
    const std::string statements =
        "float f(float x) {\n" + times(5000, "x += t[3];\n") + "return x; }\n";
    CHECK(check(fragment_with(table + statements)).has_value());
}

TEST_CASE("a cache returns the same results as the check, from several threads") {
    CheckCache cache;
    const Stage good = fragment_with("uniform float a = 0.5;");
    const Stage bad = fragment_with("float a = b;");
    const Stage elsewhere = fragment_with("float a = b;", "other.frag");
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            for (const Stage* stage : {&good, &bad, &elsewhere})
                static_cast<void>(cache.check(fullscreen_vertex_stage(), *stage));
        });
    for (std::thread& thread : threads)
        thread.join();
    for (const Stage* stage : {&good, &bad, &elsewhere})
        CHECK(cache.check(fullscreen_vertex_stage(), *stage) == check(*stage));
}

namespace {
// The linear congruential generator of Numerical Recipes: the same mutations on every machine.
class RandomNumbers {
public:
    std::size_t below(std::size_t end) {
        m_state = m_state * 1664525u + 1013904223u;
        return (m_state >> 8) % end;
    }

private:
    std::uint32_t m_state = 2024;
};

std::string mutated(std::string text, RandomNumbers& random_numbers) {
    constexpr std::string_view pieces[] = {
        "(",  ")", "{",  "}",     ";",      "\"",       "/*",      "*/",
        "//", "#", "\n", "@",     "@range", "uniform ", "#if 1\n", "\\\n",
        "=",  "[", "]",  "1e999", "vec3",   "\x80",     "\x01",    "#define A "};
    for (std::size_t i = 0; i < 1 + random_numbers.below(4); ++i) {
        const std::size_t at = random_numbers.below(text.size());
        const std::size_t length = random_numbers.below(12);
        if (random_numbers.below(2) == 0)
            text.erase(at, length);
        else
            text.insert(at, random_numbers.below(2) == 0
                                ? std::string(pieces[random_numbers.below(std::size(pieces))])
                                : text.substr(random_numbers.below(text.size()), length));
    }
    return text;
}
}  // namespace

TEST_CASE("random mutations give a valid result or errors with file and line, never a crash") {
    const std::string valid =
        "#version 410 core\n"
        "uniform float decay = 0.92;  // @range 0.5 0.999  @label \"Decay\"\n"
        "uniform vec3 tint = vec3(0.2, 1, 0.3), other;  // @color\n"
        "layout(location = 0) out vec4 color;\n"
        "#define TWICE(x) ((x) * 2.0)\n"
        "#if 1\nconst float table[3] = float[3](1.0, 2.0, 3.0);\n#endif\n"
        "struct Ray { vec3 from; vec3 to; };\n"
        "float f(in Ray ray, int n) { return n > 0 ? dot(ray.from, ray.to) : table[n]; }\n"
        "void main() {\n"
        "    for (int i = 0; i < 3; ++i) color.r += f(Ray(tint, other), i);\n"
        "    if (color.r > 1.0) discard; else color = vec4(tint * TWICE(decay), 1.0);\n"
        "}\n";
    REQUIRE(check(stage_of("a.frag", valid)).has_value());
    RandomNumbers random_numbers;
    for (int i = 0; i < 400; ++i) {
        const std::string text = mutated(valid, random_numbers);
        CAPTURE(text);
        const auto reflection = check(stage_of("a.frag", text));
        if (reflection)
            continue;
        REQUIRE_FALSE(reflection.error().empty());
        for (const Diagnostic& diagnostic : reflection.error()) {
            CHECK(diagnostic.file == "a.frag");
            CHECK(diagnostic.line >= 1);
            CHECK_FALSE(diagnostic.message.empty());
        }
    }
}

TEST_CASE("uniforms read only in unreachable code are not live") {
    const auto reflection = check(stage_of("a.frag", R"(#version 410 core
uniform sampler2D read; uniform sampler2D skipped; uniform float unused; uniform float called;
const int part = 1;
float never() { return unused; }
float always() { return called; }
out vec4 c;
void main() {
    if (part == 0)
        c = texture(skipped, vec2(0.5));
    else
        c = texture(read, vec2(always()));
}
)"));
    REQUIRE(reflection.has_value());
    CHECK(reflection->uniforms.size() == 4);
    std::vector<std::string> live = reflection->live;
    std::ranges::sort(live);
    CHECK(live == std::vector<std::string>{"called", "read"});
}

TEST_CASE("uniforms read by the initial values of global variables are live") {
    const auto reflection = check(stage_of("a.frag", R"(#version 410 core
uniform float one; uniform float two; uniform float three; uniform float unused;
float first = one;
float second = two, third = second + three;
float never = unused;
out vec4 c;
void main() { c = vec4(first, third, 0.0, 1.0); }
)"));
    REQUIRE(reflection.has_value());
    std::vector<std::string> live = reflection->live;
    std::ranges::sort(live);
    CHECK(live == std::vector<std::string>{"one", "three", "two"});
}
