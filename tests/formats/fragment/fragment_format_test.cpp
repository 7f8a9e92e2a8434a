#include "formats/fragment/fragment_format.h"

#include "formats/fragment/varyings.h"
#include "formats/look_format.h"
#include "io/temporary_folder.h"
#include "problems_of.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
Look fragment_look(const std::string& text, const std::string& expected_warning = "") {
    const TemporaryFolder folder;
    const LoadedLook loaded = load_fragment_look(folder.write("a.frag", text), {}, {});
    REQUIRE_MESSAGE(loaded.look.has_value(), problems_of(loaded.look));
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

TEST_CASE("a shader of The Book of Shaders opens with time, resolution and mouse") {
    const Look look = fragment_look(
        "#ifdef GL_ES\nprecision mediump float;\n#endif\n"
        "uniform vec2 u_resolution;\nuniform vec2 u_mouse;\nuniform float u_time;\n"
        "void main() {\n    vec2 st = gl_FragCoord.xy / u_resolution;\n"
        "    gl_FragColor = vec4(st, abs(sin(u_time)) + u_mouse.x, 1.0);\n}\n");
    CHECK(look.parameters.empty());
    CHECK(look.passes.size() == 1);
    CHECK(look.driven_by == Driver::nothing);
    CHECK(look.passes[0].built_ins.size() == 3);
}

TEST_CASE("a GameMaker shader processes the source") {
    const Look look = fragment_look(
        "varying vec2 v_vTexcoord;\nvarying vec4 v_vColour;\nuniform float strength;\n"
        "uniform sampler2D gm_BaseTexture;\n"
        "void main() { gl_FragColor = v_vColour * texture2D(gm_BaseTexture, v_vTexcoord) * "
        "strength; }\n");
    CHECK(look.driven_by == Driver::picture);
    REQUIRE(look.passes[0].inputs.size() == 1);
    CHECK(look.passes[0].inputs[0].from == Input::From::source);
    CHECK(names_in(look) == "strength");
}

TEST_CASE("GLSL ES 3.00 and desktop versions keep their own inputs and outputs") {
    fragment_look(
        "#version 300 es\nprecision highp float;\nin vec2 vUv;\nout vec4 fragColor;\n"
        "uniform sampler2D tDiffuse;\n"
        "void main() { fragColor = texture(tDiffuse, vUv); }\n");
    fragment_look(
        "#version 120\nuniform float time;\nuniform vec2 resolution;\n"
        "void main() { gl_FragData[0] = vec4(gl_FragCoord.xy / resolution, time, 1.0); }\n");
    fragment_look(
        "#version 450 core\nlayout(location = 0) in vec2 uv;\nlayout(location = 0) out vec4 c;\n"
        "void main() { c = vec4(uv, 0.0, 1.0); }\n");
}

TEST_CASE("other uniforms are parameters with their annotations, and other samplers are images") {
    const Look look = fragment_look(
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

TEST_CASE("a varying that the built-in vertex shader does not set gives a warning with its line") {
    fragment_look(
        "uniform float a;\nvarying float fog;\nvoid main() { gl_FragColor = vec4(fog * a); }\n",
        "a.frag:2: warning: no vertex shader sets 'fog'; float(0) is used");
}

TEST_CASE("varyings are found in every syntax") {
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

TEST_CASE("varyings beyond the limit are an error at the first excess line") {
    const TemporaryFolder folder;
    std::string text = "#version 100\n";
    for (int i = 0; i < 257; ++i)
        text += "varying float v" + std::to_string(i) + ";\n";
    const auto file = folder.write("a.frag", text + "void main() {}\n");
    const LoadedLook loaded = load_fragment_look(file, {}, {});
    REQUIRE_FALSE(loaded.look.has_value());
    CHECK(to_string(loaded.look.error()) ==
          file.string() + ":258: error: the shader has 257 varyings; the limit is 256\n");
}

TEST_CASE("built-ins of GameMaker need no declaration") {
    const Look look = fragment_look(
        "varying vec2 v_vTexcoord;\nvarying LOWPREC vec4 v_vColour;\n"
        "void main() {\n"
        "    vec4 color = v_vColour * texture2D(gm_BaseTexture, v_vTexcoord);\n"
        "    DoAlphaTest(color);\n    DoFog(color, 1.0);\n"
        "    if (gm_PS_FogEnabled) color = gm_FogColour * gm_AlphaRefValue;\n"
        "    gl_FragColor = color;\n}\n");
    CHECK(look.driven_by == Driver::picture);
    REQUIRE(look.passes[0].inputs.size() == 1);
    CHECK(look.passes[0].inputs[0].from == Input::From::source);
    CHECK(look.parameters.empty());
}

TEST_CASE("built-ins and includes of three.js need no declaration") {
    const Look look = fragment_look(
        "#include <common>\n#include <packing>\nvarying vec2 vUv;\n"
        "void main() {\n"
        "    vec3 seen = normalize(cameraPosition - vec3(vUv, 0.0));\n"
        "    float z = perspectiveDepthToViewZ(pow2(seen.z), 0.1, 9.0) * PI;\n"
        "    gl_FragColor = saturate((viewMatrix * vec4(seen, z)) * rand(vUv));\n"
        "    #include <tonemapping_fragment>\n}\n");
    CHECK(look.parameters.empty());
}

TEST_CASE("names declared by the author are not declared again") {
    fragment_look(
        "#include <common>\n#define PI 3.0\nfloat rand(vec2 at) { return at.x; }\n"
        "vec3 other, cameraPosition;\n"
        "void main() {\n    cameraPosition = vec3(PI);\n    vec4 viewMatrix = vec4(1.0);\n"
        "    gl_FragColor = vec4(cameraPosition, rand(vec2(0.5))) * viewMatrix;\n}\n");
}

TEST_CASE("an unknown include of three.js is an error at its line") {
    const TemporaryFolder folder;
    const auto file =
        folder.write("a.frag", "#include <common>\n#include <lights_pars_begin>\nvoid main() {}\n");
    const LoadedLook loaded = load_fragment_look(file, {}, {});
    REQUIRE_FALSE(loaded.look.has_value());
    CHECK(to_string(loaded.look.error()) ==
          file.string() +
              ":2: error: unknown include <lights_pars_begin>; to include a file, use #include "
              "\"file.glsl\"\n");
}

TEST_CASE("layout locations, bindings and syntax after GLSL 4.10 are accepted") {
    const Look look = fragment_look(
        "#version 450\nlayout(location = 1) in vec2 uv;\nlayout(location = 0) in vec4 tint;\n"
        "layout(location = 0) out vec4 color;\n"
        "layout(binding = 0) uniform sampler2D tDiffuse;\n"
        "layout(location = 3) uniform float u_time;\n"
        "void main() {\n    vec2 at = {uv.x, 0.5};\n"
        "    color = texture(tDiffuse, at) * tint * u_time;\n}\n");
    CHECK(look.passes[0].fragment.text->find("\n in vec2 uv;\n in vec4 tint;\n") !=
          std::string::npos);
    CHECK(look.passes[0].fragment.text->find("layout(location = 0) out vec4") != std::string::npos);
}

TEST_CASE("layout qualifiers other than numbers are kept") {
    const Look look = fragment_look(
        "#version 450\nlayout(std140,\n    binding = 1) uniform Block { vec4 tint; };\n"
        "layout(origin_upper_left) in vec4 gl_FragCoord;\nout vec4 color;\n"
        "void main() { color = tint + gl_FragCoord; }\n",
        "Block");
    CHECK(look.passes[0].fragment.text->find("layout(std140)\n uniform Block") !=
          std::string::npos);
    CHECK(look.passes[0].fragment.text->find("layout(origin_upper_left)") != std::string::npos);
}

TEST_CASE("legacy vertex shader outputs of GLSL before 1.30 are available") {
    fragment_look(
        "#version 120\nuniform sampler2D texture0;\n"
        "void main() { gl_FragColor = texture2D(texture0, gl_TexCoord[0].xy) * gl_Color; }\n");
}

TEST_CASE("with several outputs the first one is the picture") {
    fragment_look(
        "#extension GL_EXT_draw_buffers : require\nprecision highp float;\n"
        "void main() { gl_FragData[0] = vec4(1.0); gl_FragData[1] = vec4(0.0); }\n");
}

TEST_CASE("words not reserved in GLSL ES 1.00 may be names") {
    fragment_look(
        "precision mediump float;\nuniform sampler2D filter;\nuniform float active;\n"
        "varying vec2 uv;\n"
        "float smooth(float x) { return x * x; }\nfloat common(float x) { return x; }\n"
        "vec4 texture(vec2 at) { return texture2D(filter, at); }\n"
        "void main() {\n"
        "    int partition = 1; float sample = 0.5; vec2 centroid = uv; float layout = 1.0;\n"
        "    float flat = 1.0, uint = 2.0; float patch = 1.0; float buffer = 1.0;\n"
        "    gl_FragColor = texture(centroid) * smooth(active) * common(sample) * layout * flat *\n"
        "        float(partition) * patch * buffer;\n}\n");
}

TEST_CASE("GL_ES is defined in GLSL ES, but not in desktop versions") {
    const Look look = fragment_look(
        "#ifdef GL_ES\nprecision mediump float;\nvarying vec2 vUv;\n#endif\n"
        "void main() { gl_FragColor = vec4(vUv, 0.0, 1.0); }\n");
    CHECK(look.passes[0].vertex.text->find("vUv = place;") != std::string::npos);
    fragment_look(
        "#version 330\n#ifdef GL_ES\n#error this is not ES\n#endif\nout vec4 c;\n"
        "void main() { c = vec4(1.0); }\n");
}

TEST_CASE("arrays, blocks and macros may declare varyings") {
    const Look arrays = fragment_look(
        "precision mediump float;\n#define TAPS 5\nvarying vec2 blurCoord[TAPS];\n"
        "void main() { gl_FragColor = vec4(blurCoord[0], blurCoord[4].x, 1.0); }\n");
    CHECK(arrays.passes[0].vertex.text->find("out vec2 blurCoord[5];") != std::string::npos);
    fragment_look(
        "#version 330\nin VS_OUT { vec2 uv; vec3 normal; } fs_in;\nout vec4 o;\n"
        "void main() { o = vec4(fs_in.uv, fs_in.normal.z, 1.0); }\n");
    fragment_look(
        "#version 330\nin Values { vec2 uv, pos[2]; };\nout vec4 o;\n"
        "void main() { o = vec4(uv, pos[1]); }\n");
    fragment_look(
        "#version 130\n#if __VERSION__ >= 130\n#define VARYING in\nout vec4 c;\n#else\n"
        "#define VARYING varying\n#define c gl_FragColor\n#endif\nVARYING vec2 uv;\n"
        "void main() { c = vec4(uv, 0.0, 1.0); }\n");
}

TEST_CASE("a cube map and a volume are image parameters with built-in defaults") {
    const Look look = fragment_look(
        "#version 300 es\nprecision highp float;\nuniform samplerCube envMap;\n"
        "uniform highp sampler3D fog;\nout vec4 c;\n"
        "void main() { c = texture(envMap, vec3(1.0)) + texture(fog, vec3(0.5)); }\n");
    REQUIRE(names_in(look) == "envMap, fog");
    CHECK(look.parameters[0].initial.path == "solid:sky");
    CHECK(look.parameters[1].initial.path == "solid:noise-volume");
    CHECK(look.images.size() == 2);
}

TEST_CASE("buffers of glslViewer are drawn as passes, each with its macro defined") {
    const Look look = fragment_look(
        "uniform vec2 u_resolution;\nuniform sampler2D u_buffer0;\n"
        "uniform sampler2D u_doubleBuffer0;\n"
        "void main() {\n    vec2 st = gl_FragCoord.xy / u_resolution;\n"
        "#ifdef BUFFER_0\n    gl_FragColor = vec4(st, 0.0, 1.0);\n"
        "#elif defined(DOUBLE_BUFFER_0)\n"
        "    gl_FragColor = texture2D(u_doubleBuffer0, st) + texture2D(u_buffer0, st);\n"
        "#else\n    gl_FragColor = texture2D(u_doubleBuffer0, st);\n#endif\n}\n");
    REQUIRE(pass_names(look) ==
            std::vector<std::string>{"u_buffer0", "u_doubleBuffer0", "picture"});
    const auto ago = [&](std::size_t pass, const char* uniform) {
        const auto& inputs = look.passes[pass].inputs;
        const auto found = std::ranges::find(inputs, uniform, &Input::uniform);
        REQUIRE(found != inputs.end());
        return found->frames_ago;
    };
    CHECK(ago(1, "u_buffer0") == 0);
    CHECK(ago(1, "u_doubleBuffer0") == 1);
    CHECK(ago(2, "u_doubleBuffer0") == 0);
    CHECK(look.passes[0].format == Format::rgba32f);
    CHECK(look.passes[2].format == Format::rgba8);
    CHECK(look.parameters.empty());
}

TEST_CASE("scenes of glslViewer give a warning that they are not available") {
    fragment_look(
        "uniform float a;\nuniform sampler2D u_scene;\n"
        "void main() { gl_FragColor = texture2D(u_scene, vec2(0.5)) * a; }\n",
        "a.frag:2: warning: 'u_scene' is a scene or buffer of glslViewer, which isn't available "
        "here. Choose a picture for it.");
}

TEST_CASE("errors of glslang are reported at the author's line") {
    const TemporaryFolder folder;
    const LoadedLook loaded = load_fragment_look(
        folder.write("a.frag", "#version 100\nvoid main() {\n    gl_FragColor = nothing;\n}\n"), {},
        {});
    REQUIRE_FALSE(loaded.look.has_value());
    CHECK(loaded.look.error().front().line == 3);
}

TEST_CASE("a varying with an unknown type is an error at its line in both stages") {
    const TemporaryFolder folder;
    const auto file = folder.write("a.frag", "#version 100\nvarying vect at;\nvoid main() { }\n");
    const LoadedLook loaded = load_fragment_look(file, {}, {});
    REQUIRE_FALSE(loaded.look.has_value());
    for (const Diagnostic& error : loaded.look.error()) {
        CHECK(error.file == file);
        CHECK(error.line == 2);
    }
}

TEST_CASE("a bare shader is recognised by its main()") {
    const TemporaryFolder folder;
    CHECK(is_fragment_file(folder.write("a.glsl", "void main() {}")));
    CHECK_FALSE(
        is_fragment_file(folder.write("b.glsl", "float helper() { return 1.0; } // main()")));
    CHECK_FALSE(is_fragment_file(folder.write("a.txt", "void main() {}")));
}

TEST_CASE("a constant with a range is a parameter, and errors keep their line") {
    const TemporaryFolder folder;
    const auto file = folder.write("a.frag",
                                   "precision mediump float;\n"
                                   "#define N 4  // @range 1 9\n"
                                   "void main() {\n"
                                   "    float taps[N];\n"
                                   "    gl_FragColor = vec4(taps[0]);\n"
                                   "}\n");
    const LoadedLook plain = load_fragment_look(file, {}, {});
    REQUIRE_MESSAGE(plain.look.has_value(), problems_of(plain.look));
    CHECK(find_parameter(*plain.look, "N")->range == Range{1.0, 9.0, 1.0});
    const Values none{{"N", 0.0}};
    const LoadedLook empty = load_fragment_look(file, {}, {nullptr, nullptr, &none});
    REQUIRE_FALSE(empty.look.has_value());
    CHECK(empty.look.error().front().line == 4);
}

TEST_CASE("a fragment shader may include files above its folder, as with lygia") {
    const std::filesystem::path inputs =
        std::filesystem::path(AFTERGLOW_SOURCE_DIR) / "tests/inputs";
    const LoadedLook loaded = load_fragment_look(inputs / "bare/sub/up.frag", {}, {});
    REQUIRE_MESSAGE(loaded.look.has_value(), problems_of(loaded.look));
    const std::string& text = loaded.look->passes[0].fragment.text;
    CHECK(text.find("float tint(){return 0.5;}") != std::string::npos);

    const TemporaryFolder folder;
    folder.write("lib/tint.glsl", "float tint(){return 0.5;}\n");
    const auto shadertoy =
        folder.write("toys/a.glsl",
                     "#include \"../lib/tint.glsl\"\n"
                     "void mainImage(out vec4 o, in vec2 f){ o = vec4(tint()); }\n");
    const LoadedLook opened = load_look(shadertoy, {}, {});
    CHECK_MESSAGE(opened.look.has_value(), problems_of(opened.look));
}
