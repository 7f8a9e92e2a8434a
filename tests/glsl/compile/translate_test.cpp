#include "glsl/compile/translate.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
constexpr const char* quad = R"(#version 450
layout(std140, set = 0, binding = 0) uniform UBO { mat4 MVP; float unread; } global;
layout(push_constant) uniform Push { vec4 OutputSize; } params;
layout(location = 0) in vec4 Position;
layout(location = 1) in vec2 TexCoord;
layout(location = 0) out vec2 vTexCoord;
layout(location = 1) out float size;
void main() { gl_Position = global.MVP * Position; vTexCoord = TexCoord; size = params.OutputSize.x; }
)";

Stage stage(const std::string& name, const std::string& text) {
    Stage made{name, text, {}};
    for (int line = 1; line <= 60; ++line)
        made.lines.push_back({name, line + 100});
    return made;
}

Result<Translation> translated(const std::string& fragment, const std::string& vertex = quad) {
    return translate_from_vulkan(stage("a.slang", vertex), stage("b.slang", fragment));
}

const std::string head =
    "#version 450\nlayout(location = 0) in vec2 other_name;\n"
    "layout(location = 0) out vec4 color;\n";

std::vector<std::string> members(const Translation& translation) {
    std::vector<std::string> names;
    for (const BlockMember& member : translation.members)
        names.push_back(member.name + " = " + member.uniform);
    std::ranges::sort(names);
    return names;
}
}  // namespace

TEST_CASE("blocks and push constants become plain uniforms with a prefix per stage") {
    const auto made = translated(
        head +
        "layout(std140, binding = 0) uniform UBO { mat4 MVP; uint FrameCount; } global;\n"
        "layout(push_constant) uniform Push { float glow; vec4 never[2]; } params;\n"
        "layout(binding = 2) uniform sampler2D Source;\n"
        "void main() { color = texture(Source, other_name) * params.glow + "
        "float(global.FrameCount); }\n");
    REQUIRE(made);
    CHECK(members(*made) == std::vector<std::string>{"FrameCount = fragment_uniforms.FrameCount",
                                                     "MVP = vertex_uniforms.MVP",
                                                     "OutputSize = vertex_constants.OutputSize",
                                                     "glow = fragment_constants.glow"});
    REQUIRE(made->samplers.size() == 1);
    CHECK(made->samplers[0].uniform == "Source");
    CHECK(made->fragment.text->starts_with("#version 410"));
    for (const char* word : {"binding", "push_constant", "std140", "#line", "GOOGLE"})
        CHECK(made->fragment.text->find(word) == std::string::npos);
    const auto frames = std::ranges::find(made->members, "FrameCount", &BlockMember::name);
    CHECK(frames->type == NumberType{Scalar::unsigned_integer, 1, 1});
}

TEST_CASE("a sampler whose name is invalid in OpenGL is found under its new name") {
    const auto made = translated(head +
                                 "layout(binding = 2) uniform sampler2D noise1;\n"
                                 "void main() { color = texture(noise1, other_name); }\n");
    REQUIRE(made);
    REQUIRE(made->samplers.size() == 1);
    CHECK(made->samplers[0].name == "noise1");
    CHECK(made->fragment.text->find("uniform sampler2D " + made->samplers[0].uniform + ";") !=
          std::string::npos);
}

TEST_CASE("unused samplers are removed") {
    const auto made = translated(head +
                                 "layout(binding = 2) uniform sampler2D Source;\n"
                                 "layout(binding = 3) uniform sampler2D Unused;\n"
                                 "void main() { color = texture(Source, other_name); }\n");
    REQUIRE(made);
    CHECK(made->samplers.size() == 1);
    CHECK(made->fragment.text->find("Unused") == std::string::npos);
}

TEST_CASE("a varying's interpolation is copied from the fragment to the vertex stage") {
    const auto made = translated(head +
                                 "layout(location = 1) flat in float size;\n"
                                 "void main() { color = vec4(size); }\n");
    REQUIRE(made);
    CHECK(made->vertex.text->find("flat out float size") != std::string::npos);
    CHECK(made->vertex.text->find("flat out vec2") == std::string::npos);
}

TEST_CASE(
    "functions missing in GLSL 4.10 require an extension, only in the stage that calls them") {
    const std::string wanted = "#extension GL_ARB_shading_language_packing : require\n";
    const auto packing = translated(
        head + "void main() { color = unpackHalf2x16(packHalf2x16(other_name)).xyxy; }\n");
    REQUIRE(packing.has_value());
    CHECK(packing->fragment.text->starts_with("#version 410\n" + wanted));
    CHECK(packing->vertex.text->find(wanted) == std::string::npos);
    CHECK(static_cast<std::ptrdiff_t>(packing->fragment.lines.size()) ==
          std::ranges::count(*packing->fragment.text, '\n'));
}

TEST_CASE("errors are located at the original lines") {
    const auto made = translated(head + "void main() { color = vec4(missing); }\n");
    REQUIRE_FALSE(made);
    CHECK(made.error().front().file == "b.slang");
    CHECK(made.error().front().line == 104);
    CHECK(made.error().front().message.find("missing") != std::string::npos);
}

TEST_CASE("lines of the translated text map to the original lines") {
    const auto made = translated(head +
                                 "\n\nvoid main()\n{\n    vec4 a = vec4(other_name.x);\n"
                                 "    if (a.x > 0.5)\n        discard;\n    color = a;\n}\n");
    REQUIRE(made);
    const std::vector<std::string_view> lines = split_lines(made->fragment.text);
    const auto discards =
        std::ranges::find_if(lines, [](std::string_view line) { return trim(line) == "discard;"; });
    REQUIRE(discards != lines.end());
    const Location at =
        origin_of(made->fragment.lines, static_cast<int>(discards - lines.begin()) + 1);
    CHECK(at.file == "b.slang");
    CHECK(at.line == 110);
}

TEST_CASE("unsupported storage buffers and second uniform blocks are named in the error") {
    const auto storage = translated(head +
                                    "layout(std430, binding = 1) buffer Store { float x; } store;\n"
                                    "void main() { color = vec4(store.x); }\n");
    REQUIRE_FALSE(storage);
    CHECK(storage.error().front().message.find("storage buffer") != std::string::npos);
    const auto second = translated(head +
                                   "layout(binding = 0) uniform A { float x; } a;\n"
                                   "layout(binding = 1) uniform B { float y; } b;\n"
                                   "void main() { color = vec4(a.x + b.y); }\n");
    REQUIRE_FALSE(second);
    CHECK(second.error().front().message.find("second uniform block") != std::string::npos);
}
