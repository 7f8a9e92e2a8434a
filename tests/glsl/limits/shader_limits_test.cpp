#include "model/look/shader_limits.h"

#include "glsl/cache/check_cache.h"
#include "glsl/compile/check.h"
#include "glsl/compile/translate.h"
#include "glsl/shader_texts.h"
#include "in_a_moment.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

namespace {
Stage fragment(const std::string& before, const std::string& body) {
    return stage_of("a.frag", "#version 410 core\nin vec2 uv;\nout vec4 color;\n" + before +
                                  "void main() {\n" + body + "color = vec4(uv, 0, 1);\n}\n");
}

// The errors of a fragment shader; "": none.
std::string refused(const Stage& stage, const ShaderLimits& limits = {}) {
    const auto checked = check_program(fullscreen_vertex_stage(), stage, limits);
    return checked ? std::string() : to_string(checked.error());
}

bool names(const std::string& message, const std::string& limit) {
    return message.find("--limit " + limit + "=") != std::string::npos;
}

// Functions that each call the previous one `calls` times.
std::string call_tree(int levels, int calls) {
    std::string text = "float f0(float x) { return x * 2.0; }\n";
    for (int i = 1; i < levels; ++i) {
        std::string sum = fmt::format("f{}(x)", i - 1);
        for (int call = 1; call < calls; ++call)
            sum += fmt::format(" + f{}(x)", i - 1);
        text += fmt::format("float f{}(float x) {{ return {}; }}\n", i, sum);
    }
    return text;
}

// Structs that each contain the previous one `copies` times.
std::string struct_tree(int levels, int copies) {
    std::string text = "struct S0 { float x; };\n";
    for (int i = 1; i < levels; ++i) {
        std::string members = "a0";
        for (int copy = 1; copy < copies; ++copy)
            members += fmt::format(", a{}", copy);
        text += fmt::format("struct S{} {{ S{} {}; }};\n", i, i - 1, members);
    }
    return text;
}

std::string cases(int count) {
    std::string text = "switch (int(uv.x)) {\n";
    for (int i = 0; i < count; ++i)
        text += fmt::format("case {}: color.x = {}.0; break;\n", i, i);
    return text + "}\n";
}

std::string uniforms(int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += fmt::format("uniform float u{};\n", i);
    return text;
}
}  // namespace

TEST_CASE("variables take at most 1 MiB") {
    // 4 bytes per float; 'uv' and 'color' take 24.
    constexpr int maximum = ((1 << 20) - 24) / 4;
    CHECK(refused(fragment("", fmt::format("float a[{}]; a[3] = 1.0;\n", maximum))) == "");
    CHECK(names(refused(fragment("", fmt::format("float a[{}]; a[3] = 1.0;\n", maximum + 1))),
                "variable-bytes"));
    const std::string global = fmt::format("vec4 a[{}];\n", maximum);
    CHECK(names(refused(fragment(global, "a[3] = vec4(1.0);\n")), "variable-bytes"));
    CHECK(names(refused(fragment("", "float a[1100000000]; a[3] = 1.0;\n")), "variable-bytes"));
    CHECK(names(refused(fragment("uniform float u[300000];\n", "color.x = u[3];\n")),
                "variable-bytes"));
    const std::string nested = "struct S { mat4 m[100]; }; struct T { S s[100]; };\n";
    CHECK(names(refused(fragment(nested, "T t[2]; t[0].s[0].m[0] = mat4(1.0);\n")),
                "variable-bytes"));
}

TEST_CASE("an array in a function counts once per call") {
    const std::string text = "float f(float x) { float a[1000]; a[3] = x; return a[3]; }\n";
    std::string calls;
    for (int i = 0; i < 300; ++i)
        calls += "color.x += f(uv.x);\n";
    CHECK(names(refused(fragment(text, calls)), "variable-bytes"));
    CHECK(refused(fragment(text, "color.x += f(uv.x);\n")) == "");
}

TEST_CASE("arrays with a computed index have a lower limit") {
    const auto with = [](const std::string& type, int count, const std::string& value) {
        return fragment("", fmt::format("{} a[{}]; a[int(uv.x)] = {};\n", type, count, value));
    };
    CHECK(refused(with("float", 16384, "1.0")) == "");
    CHECK(names(refused(with("float", 16385, "1.0")), "indexed-bytes"));
    CHECK(refused(with("vec4", 4096, "vec4(1.0)")) == "");
    CHECK(names(refused(with("vec4", 4097, "vec4(1.0)")), "indexed-bytes"));
    // The same limit applies to the arrays of all calls.
    const std::string text = "float f(float x) { float a[100]; a[int(x)] = x; return a[3]; }\n";
    std::string calls;
    for (int i = 0; i < 163; ++i)
        calls += "color.x += f(uv.x);\n";
    CHECK(refused(fragment(text, calls)) == "");
    CHECK(names(refused(fragment(text, calls + "color.x += f(uv.y);\n")), "indexed-bytes"));
    // A uniform array is stored by the driver.
    CHECK(refused(fragment("uniform float u[5000];\n", "color.x = u[int(uv.x)];\n")) == "");
}

TEST_CASE("members of uniform structs count as uniforms") {
    CHECK(refused(fragment(uniforms(1024), "")) == "");
    CHECK(names(refused(fragment(uniforms(1025), "")), "uniforms"));
    // An array of numbers is one uniform; an array of structs counts each member.
    CHECK(refused(fragment("uniform float u[2000];\n", "")) == "");
    const std::string members = "struct S { float a, b; }; uniform S s[{}];\n";
    CHECK(refused(fragment("struct S { float a, b; }; uniform S s[512];\n", "")) == "");
    CHECK(
        names(refused(fragment("struct S { float a, b; }; uniform S s[513];\n", "")), "uniforms"));
}

TEST_CASE("calls are counted as if inlined") {
    // A function of level n makes 2 + 4 + ... + 2^n = 2^(n + 1) - 2 calls; main adds one.
    CHECK(refused(fragment(call_tree(14, 2), "color.x = f13(uv.x);\n")) == "");  // 16,383
    CHECK(names(refused(fragment(call_tree(15, 2), "color.x = f14(uv.x);\n")), "inlined-calls"));
    CHECK(names(refused(fragment(call_tree(18, 2), "color.x = f17(uv.x);\n")), "inlined-calls"));
    CHECK(names(refused(fragment(call_tree(30, 2), "color.x = f29(uv.x);\n")), "inlined-calls"));
    CHECK(names(refused(fragment(call_tree(12, 3), "color.x = f11(uv.x);\n")), "inlined-calls"));
    // Drivers also inline functions that main does not reach.
    CHECK(names(refused(fragment(call_tree(30, 2), "")), "inlined-calls"));
}

TEST_CASE("operations of a function count once per call") {
    std::string text = "float f(float x) {\n";
    for (int i = 0; i < 300; ++i)
        text += "x = x * 2.0;\n";  // a product and an assignment
    text += "return x;\n}\n";
    std::string calls;
    for (int i = 0; i < 840; ++i)
        calls += "color.x += f(uv.x);\n";
    CHECK(names(refused(fragment(text, calls)), "instructions"));  // at least 840 * 600
    CHECK(refused(fragment(text, calls.substr(0, calls.size() / 2))) == "");
}

TEST_CASE("a copy of an array counts each element") {
    std::string copies = "float a[1000]; float b[1000]; a[0] = uv.x;\n";
    for (int i = 0; i < 505; ++i)
        copies += "b = a;\n";
    CHECK(names(refused(fragment("", copies)), "instructions"));
    std::string calls;
    for (int i = 0; i < 505; ++i)
        calls += "color.x += f(a);\n";
    CHECK(names(refused(fragment("float f(float a[1000]) { return a[3]; }\n",
                                 "float a[1000]; a[0] = uv.x;\n" + calls)),
                "variable-bytes"));
}

TEST_CASE("comparisons of arrays and structs count each number, up to 4096") {
    const std::string type = "struct S { vec4 v[250]; float f; };\n";  // 1001 numbers
    const auto comparing = [&](int count, const std::string& more) {
        std::string body = "S s; S t; s.f = uv.x; t.f = uv.y; float a[92]; float b[92];\n" + more;
        for (int i = 0; i < count; ++i)
            body += i % 2 == 0 ? "if (s == t) color.x += 1.0;\n" : "if (s != t) color.x += 1.0;\n";
        return fragment(type, body);
    };
    CHECK(refused(comparing(4, "if (a == b) color.y = 1.0;\n")) == "");  // 4004 + 92
    CHECK(names(refused(comparing(4,
                                  "if (a == b) color.y = 1.0;\nfloat c[1]; float d[1];\n"
                                  "if (c == d) color.y = 1.0;\n")),
                "compared-values"));
    CHECK(names(refused(comparing(150, "")), "compared-values"));
    CHECK(refused(fragment("", "if (uv == color.xy) color.x = 1.0;\n")) == "");
    std::string calls;
    for (int i = 0; i < 5; ++i)
        calls += "color.x += f();\n";
    const std::string called = type + "S s; S t; float f() { return s == t ? 1.0 : 0.0; }\n";
    CHECK(names(refused(fragment(called, calls)), "compared-values"));
}

TEST_CASE("structs and calls are nested at most 64 levels deep") {
    const auto structs = [](int levels) {
        return fragment(struct_tree(levels, 1), fmt::format("S{} s;\n", levels - 1));
    };
    CHECK(refused(structs(64)) == "");
    CHECK(names(refused(structs(65)), "depth"));
    const auto calls = [](int levels) {  // main is a level too
        return fragment(call_tree(levels, 1), fmt::format("color.x = f{}(uv.x);\n", levels - 1));
    };
    CHECK(refused(calls(63)) == "");
    CHECK(names(refused(calls(64)), "depth"));
    CHECK(names(refused(calls(20'000)), "depth"));
}

TEST_CASE("a struct has at most 4096 members, nested ones included") {
    CHECK(refused(fragment(struct_tree(13, 2), "S12 s;\n")) == "");  // 2^12
    bool is_refused = false;
    CHECK(is_done_in_a_moment([&] {
        is_refused = names(refused(fragment(struct_tree(30, 2), "S29 s;\n")), "struct-members");
    }));
    CHECK(is_refused);
    std::string macros =
        "#define PAIR(NEW, OLD) struct NEW { OLD a, b; };\nstruct S0 { float x; };\n";
    for (int i = 1; i < 30; ++i)
        macros += fmt::format("PAIR(S{}, S{})\n", i, i - 1);
    CHECK(is_done_in_a_moment(
        [&] { is_refused = names(refused(fragment(macros, "S29 s;\n")), "struct-members"); }));
    CHECK(is_refused);
}

TEST_CASE("a switch has at most 1280 cases") {
    CHECK(refused(fragment("", cases(1280))) == "");
    CHECK(names(refused(fragment("", cases(1281))), "switch-cases"));
    bool is_refused = false;
    CHECK(is_done_in_a_moment(
        [&] { is_refused = names(refused(fragment("", cases(30'000))), "switch-cases"); }));
    CHECK(is_refused);
    const std::string macro =
        "#define TEN(n) case n: case n + 1: case n + 2: case n + 3: case n + 4: "
        "case n + 5: case n + 6: case n + 7: case n + 8: case n + 9:\n";
    std::string body = "switch (int(uv.x)) {\n";
    for (int i = 0; i < 129; ++i)
        body += fmt::format("TEN({})\n", 10 * i);
    CHECK(names(refused(fragment(macro, body + "color.x = 1.0; break;\n}\n")), "switch-cases"));
}

TEST_CASE("a limit error names the line and the value that would suffice") {
    CHECK(refused(fragment("", "\nfloat a[300000]; a[3] = 1.0;\n")) ==
          "a.frag:6: error: the shader has 1200024 bytes of variables; the limit is 1048576. "
          "Simplify it, or raise the limit with --limit variable-bytes=1200024\n");
}

TEST_CASE("a raised limit accepts the same text, also with a cache") {
    const Stage stage = fragment("", cases(1281));
    ShaderLimits raised;
    REQUIRE(set_limit(raised, "switch-cases=1300").has_value());
    CHECK(refused(stage, raised) == "");
    CheckCache usual;
    CheckCache other(nullptr, raised);
    CHECK_FALSE(usual.check(fullscreen_vertex_stage(), stage).has_value());
    CHECK(other.check(fullscreen_vertex_stage(), stage).has_value());
}

TEST_CASE("Vulkan shaders have the same limits") {
    const Stage vertex = stage_of("a.slang",
                                  "#version 450\nlayout(location = 0) in vec4 Position;\n"
                                  "void main() { gl_Position = Position; }\n");
    const auto with = [](const std::string& body) {
        return stage_of("a.slang",
                        "#version 450\nlayout(location = 0) out vec4 color;\n"
                        "void main() { " +
                            body + " color = vec4(1.0); }\n");
    };
    const auto small =
        translate_from_vulkan(vertex, with("float a[64]; a[int(gl_FragCoord.x)] = 1.0;"));
    CHECK(small.has_value());
    const auto large = translate_from_vulkan(vertex, with("float a[2000000000]; a[1] = 1.0;"));
    REQUIRE_FALSE(large.has_value());
    CHECK(names(to_string(large.error()), "variable-bytes"));
}
