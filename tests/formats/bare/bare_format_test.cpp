#include "formats/bare/bare_format.h"

#include "formats/bare/varyings.h"
#include "io/temporary_folder.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
Look bare_look(const std::string& text, const std::string& expected_warning = "") {
    const TemporaryFolder folder;
    const LoadedLook loaded = load_bare_look(folder.write("a.frag", text), {}, {});
    REQUIRE_MESSAGE(loaded.look.has_value(), to_string(loaded.look.error()));
    if (expected_warning.empty())
        CHECK(to_string(loaded.warnings) == "");
    else
        CHECK(to_string(loaded.warnings).find(expected_warning) != std::string::npos);
    return *loaded.look;
}

std::string names_in(const Look& look) {
    std::string names;
    for (const Parameter& parameter : look.parameters)
        names += (names.empty() ? "" : ", ") + parameter.name;
    return names;
}
}  // namespace

TEST_CASE("a shader of The Book of Shaders opens with its time, size and mouse") {
    const Look look = bare_look(
        "#ifdef GL_ES\nprecision mediump float;\n#endif\n"
        "uniform vec2 u_resolution;\nuniform vec2 u_mouse;\nuniform float u_time;\n"
        "void main() {\n    vec2 st = gl_FragCoord.xy / u_resolution;\n"
        "    gl_FragColor = vec4(st, abs(sin(u_time)) + u_mouse.x, 1.0);\n}\n");
    CHECK(look.parameters.empty());
    CHECK(look.passes.size() == 1);
    CHECK(look.driven_by == Driver::nothing);
    CHECK(look.passes[0].built_ins.size() == 3);
}

TEST_CASE("a shader of GameMaker works on the source, seen upright") {
    const Look look = bare_look(
        "varying vec2 v_vTexcoord;\nvarying vec4 v_vColour;\nuniform float strength;\n"
        "uniform sampler2D gm_BaseTexture;\n"
        "void main() { gl_FragColor = v_vColour * texture2D(gm_BaseTexture, v_vTexcoord) * "
        "strength; }\n");
    CHECK(look.driven_by == Driver::picture);
    REQUIRE(look.passes[0].inputs.size() == 1);
    CHECK(look.passes[0].inputs[0].from == Input::From::source);
    CHECK(names_in(look) == "strength");
}

TEST_CASE("GLSL ES 3.00 and desktop versions keep their own outputs and inputs") {
    bare_look(
        "#version 300 es\nprecision highp float;\nin vec2 vUv;\nout vec4 fragColor;\n"
        "uniform sampler2D tDiffuse;\n"
        "void main() { fragColor = texture(tDiffuse, vUv); }\n");
    bare_look(
        "#version 120\nuniform float time;\nuniform vec2 resolution;\n"
        "void main() { gl_FragData[0] = vec4(gl_FragCoord.xy / resolution, time, 1.0); }\n");
    bare_look(
        "#version 450 core\nlayout(location = 0) in vec2 uv;\nlayout(location = 0) out vec4 c;\n"
        "void main() { c = vec4(uv, 0.0, 1.0); }\n");
}

TEST_CASE("other uniforms are parameters with their hints, other samplers pictures") {
    const Look look = bare_look(
        "uniform float glow; // @range 0 3\nuniform sampler2D u_tex0;\nuniform vec2 "
        "u_tex0Resolution;\n"
        "uniform sampler2D noise_map;\n"
        "void main() { gl_FragColor = texture2D(u_tex0, gl_FragCoord.xy / u_tex0Resolution) * glow "
        "+ "
        "texture2D(noise_map, vec2(0.5)); }\n");
    CHECK(names_in(look) == "glow, u_tex0, noise_map");
    CHECK(look.parameters[0].range.high == 3.0);
    CHECK(look.parameters[1].initial.path == "pattern:harbour");
    CHECK(look.parameters[2].initial.path == "pattern:noise");
}

TEST_CASE("a varying that only a vertex shader could know is named with its line") {
    bare_look(
        "uniform float a;\nvarying float fog;\nvoid main() { gl_FragColor = vec4(fog * a); }\n",
        "a.frag:2: warning: 'fog' comes from a vertex shader, which is not here: it is "
        "float(0)");
}

TEST_CASE("varyings are found in every way to write them") {
    const auto found = find_varyings(
        "precision highp float;\nvarying highp vec2 a, b;\nlayout(location = 2) flat in ivec2 c;\n"
        "void f(in vec3 no) { int in_it; }\nin vec4 d;\nuniform float e;\n");
    REQUIRE(found.size() == 4);
    CHECK(found[0].name == "a");
    CHECK(found[1].name == "b");
    CHECK(found[1].type == "vec2");
    CHECK(found[2].type == "ivec2");
    CHECK(found[2].is_flat);
    CHECK(found[3].name == "d");
    CHECK(found[3].line == 5);
}

TEST_CASE("more varyings than a driver takes are refused at the line of the first too many") {
    const TemporaryFolder folder;
    std::string text = "#version 100\n";
    for (int i = 0; i < 257; ++i)
        text += "varying float v" + std::to_string(i) + ";\n";
    const auto file = folder.write("a.frag", text + "void main() {}\n");
    const LoadedLook loaded = load_bare_look(file, {}, {});
    REQUIRE_FALSE(loaded.look.has_value());
    CHECK(to_string(loaded.look.error()) ==
          file.string() + ":258: error: more than 256 values come from a vertex shader\n");
}

TEST_CASE("glslang's errors are at the author's line") {
    const TemporaryFolder folder;
    const LoadedLook loaded = load_bare_look(
        folder.write("a.frag", "#version 100\nvoid main() {\n    gl_FragColor = nothing;\n}\n"), {},
        {});
    REQUIRE_FALSE(loaded.look.has_value());
    CHECK(loaded.look.error().front().line == 3);
}

TEST_CASE("a varying of no type that there is, is told at the author's line by both stages") {
    const TemporaryFolder folder;
    const auto file = folder.write("a.frag", "#version 100\nvarying vect at;\nvoid main() { }\n");
    const LoadedLook loaded = load_bare_look(file, {}, {});
    REQUIRE_FALSE(loaded.look.has_value());
    for (const Diagnostic& error : loaded.look.error()) {
        CHECK(error.file == file);
        CHECK(error.line == 2);
    }
}

TEST_CASE("a bare shader is told by its main()") {
    const TemporaryFolder folder;
    CHECK(is_bare_file(folder.write("a.glsl", "void main() {}")));
    CHECK_FALSE(is_bare_file(folder.write("b.glsl", "float helper() { return 1.0; } // main()")));
    CHECK_FALSE(is_bare_file(folder.write("a.txt", "void main() {}")));
}

TEST_CASE("a constant with a range is a parameter, and an error keeps its line") {
    const TemporaryFolder folder;
    const auto file = folder.write("a.frag",
                                   "precision mediump float;\n"
                                   "#define N 4  // @range 1 9\n"
                                   "void main() {\n"
                                   "    float taps[N];\n"
                                   "    gl_FragColor = vec4(taps[0]);\n"
                                   "}\n");
    const LoadedLook plain = load_bare_look(file, {}, {});
    REQUIRE_MESSAGE(plain.look.has_value(), to_string(plain.look.error()));
    CHECK(find_parameter(*plain.look, "N")->range == Range{1.0, 9.0, 1.0});
    const Values none{{"N", 0.0}};
    const LoadedLook empty = load_bare_look(file, {}, {nullptr, nullptr, &none});
    REQUIRE_FALSE(empty.look.has_value());
    CHECK(empty.look.error().front().line == 4);
}
