#include "glsl/es/es_program.h"

#include <doctest/doctest.h>

namespace {
Stage stage(std::string_view text) {
    Stage stage;
    stage.file = "a.frag";
    stage.text = std::string(text);
    return stage;
}

const Stage triangle = stage(
    "#version 410 core\nout vec2 uv;\n"
    "void main() { uv = vec2(gl_VertexID & 1); gl_Position = vec4(uv, 0, 1); }\n");

std::string fragment_of(std::string_view body, const Sampler& sampler = {}) {
    const auto program = translate_to_es(
        triangle, stage("#version 410 core\nin vec2 uv;\nout vec4 color;\n" + std::string(body)),
        {{"picture", sampler}});
    return program ? program->fragment : program.error().front().message;
}

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != text.npos;
}

Sampler wrapped(Wrap wrap, Filter filter = Filter::linear) {
    Sampler sampler;
    sampler.wrap = wrap;
    sampler.filter = filter;
    return sampler;
}
}  // namespace

TEST_CASE("uniforms keep their names and lose their defaults") {
    const std::string text = fragment_of(
        "uniform float gain = 2, level = 1;\nuniform vec2 shift = vec2(1, 2);\n"
        "void main() { color = vec4(gain * level, shift, 1); }\n");
    CHECK(text.starts_with("#version 300 es\n"));
    for (const char* const declared : {"float gain;", "float level;", "vec2 shift;"})
        CHECK_MESSAGE(has(text, declared), text);
    CHECK(has(text, "precision highp float;"));
}

TEST_CASE("whole numbers are converted where GLSL ES has no implicit conversion") {
    const std::string text =
        fragment_of("uniform int count;\nvoid main() { float x = count; color = vec4(x * 2); }\n");
    CHECK_MESSAGE(has(text, "float(count)"), text);
}

TEST_CASE("a border is drawn by the shader, also in functions with a sampler") {
    constexpr std::string_view body =
        "uniform sampler2D picture;\n"
        "vec4 twice(sampler2D s, vec2 at) { return 2.0 * texture(s, at); }\n"
        "void main() { vec3 light = vec3(uv, 0.0); color = twice(picture, light.xy) + "
        "textureLod(picture, uv, 0.0); }\n";
    const std::string border = fragment_of(body, wrapped(Wrap::border));
    CHECK_MESSAGE(has(border, "es_inside"), border);
    CHECK_MESSAGE(has(border, "es_texture_lod(picture, "), border);
    CHECK_FALSE(has(fragment_of(body, wrapped(Wrap::edge)), "es_inside"));
}

TEST_CASE("a local variable can have the name of a sampler") {
    const std::string text = fragment_of(
        "uniform sampler2D picture;\nvec3 toned(vec3 light) { return light * light; }\n"
        "void main() { vec4 texel = texture(picture, uv); { vec3 picture = texel.rgb; "
        "color = vec4(toned(picture), 1.0); } }\n",
        wrapped(Wrap::border));
    CHECK_MESSAGE(text.starts_with("#version 300 es"), text);
}

TEST_CASE("a row of texels is read as a picture with one row") {
    const std::string text = fragment_of(
        "uniform sampler1D picture;\nvoid main() { color = texture(picture, uv.x); }\n");
    CHECK_MESSAGE(has(text, "texture(picture, vec2(uv.x, 0.0))"), text);
}

TEST_CASE("gathered texels and bit functions are computed") {
    const std::string gathered = fragment_of(
        "uniform sampler2D picture;\nvoid main() { color = textureGather(picture, uv, 1); }\n",
        wrapped(Wrap::mirror));
    CHECK_MESSAGE(has(gathered, "texelFetch"), gathered);
    const std::string bits = fragment_of(
        "void main() { color = vec4(bitfieldReverse(uint(uv.x)), bitCount(7u), 0, 1); }\n");
    CHECK_MESSAGE(has(bits, "es_bitfield_reverse"), bits);
}

TEST_CASE("a feature that GLSL ES lacks is named") {
    const std::string message = fragment_of(
        "uniform samplerBuffer picture;\nvoid main() { color = texelFetch(picture, 0); }\n");
    CHECK_MESSAGE(message.starts_with("GLSL ES 3.00 can't express the shader: "), message);
    CHECK_MESSAGE(
        fragment_of("void main() { color = vec4(double(uv.x)); }\n").starts_with("GLSL ES"),
        fragment_of("void main() { color = vec4(double(uv.x)); }\n"));
}
