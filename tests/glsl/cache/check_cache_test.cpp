#include "glsl/cache/check_cache.h"

#include "byte_map.h"
#include "glsl/cache/packed_answers.h"
#include "glsl/shader_texts.h"
#include "glsl/text/include.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
Stage painted(const std::string& uniforms, const std::string& color) {
    return {"paint.frag",
            "#version 410 core\n" + uniforms + "out vec4 color;\nvoid main() { color = " + color +
                "; }\n",
            {{"paint.frag", 1}, {"inc/light.glsl", 40}, {"paint.frag", 2}}};
}

const Stage vulkan_vertex{"pass.slang",
                          "#version 450\n"
                          "layout(location = 0) in vec4 Position;\n"
                          "layout(location = 1) in vec2 TexCoord;\n"
                          "layout(location = 0) out vec2 uv;\n"
                          "layout(std140, set = 0, binding = 0) uniform UBO { mat4 MVP; } global;\n"
                          "void main() { gl_Position = global.MVP * Position; uv = TexCoord; }\n",
                          {}};
const Stage vulkan_fragment{
    "pass.slang",
    "#version 450\n"
    "layout(push_constant) uniform Push { vec4 SourceSize; float gain; } params;\n"
    "layout(location = 0) in vec2 uv;\n"
    "layout(location = 0) out vec4 color;\n"
    "layout(set = 0, binding = 2) uniform sampler2D Source;\n"
    "void main() { color = texture(Source, uv) * params.gain + params.SourceSize.z; }\n",
    {}};

bool are_same(const Translation& one, const Translation& other) {
    const auto member = [](const BlockMember& a, const BlockMember& b) {
        return a.name == b.name && a.uniform == b.uniform && a.type == b.type;
    };
    const auto sampler = [](const NamedSampler& a, const NamedSampler& b) {
        return a.name == b.name && a.uniform == b.uniform;
    };
    return one.vertex == other.vertex && one.fragment == other.fragment &&
           one.warnings == other.warnings &&
           std::ranges::equal(one.members, other.members, member) &&
           std::ranges::equal(one.samplers, other.samplers, sampler);
}
}  // namespace

TEST_CASE("a result cached by a previous run is reused without compiling") {
    ByteMap store;
    const Stage fragment =
        painted("uniform vec3 tint = vec3(1, 0.5, 0);\nuniform int n;\n", "vec4(tint, float(n))");
    CheckCache first(&store);
    const auto checked = first.check(fullscreen_vertex_stage(), fragment);
    const auto translated = first.translate(vulkan_vertex, vulkan_fragment);
    REQUIRE(checked.has_value());
    REQUIRE(translated.has_value());
    CHECK(first.compilations() == 2);

    CheckCache second(&store);
    CHECK(second.check(fullscreen_vertex_stage(), fragment) == checked);
    const auto again = second.translate(vulkan_vertex, vulkan_fragment);
    REQUIRE(again.has_value());
    CHECK(are_same(*again, *translated));
    CHECK(second.compilations() == 0);
}

TEST_CASE("another text, file or line map is compiled again") {
    ByteMap store;
    const Stage fragment = painted("", "vec4(1)");
    static_cast<void>(CheckCache(&store).check(fullscreen_vertex_stage(), fragment));
    Stage moved = fragment;
    moved.file = "moved.frag";
    Stage lines = fragment;
    lines.lines = {{"paint.frag", 1}, {"inc/light.glsl", 41}, {"paint.frag", 2}};
    CheckCache cache(&store);
    for (const Stage& other : {painted("", "vec4(0)"), moved, lines})
        REQUIRE(cache.check(fullscreen_vertex_stage(), other).has_value());
    CHECK(cache.compilations() == 3);
}

TEST_CASE("errors are not cached") {
    ByteMap store;
    CHECK_FALSE(
        CheckCache(&store).check(fullscreen_vertex_stage(), painted("", "oops")).has_value());
    CHECK(store.answers.empty());
}

TEST_CASE("a corrupt cache entry is recompiled and replaced") {
    ByteMap store;
    static_cast<void>(CheckCache(&store).translate(vulkan_vertex, vulkan_fragment));
    REQUIRE(store.answers.size() == 1);
    std::string& answer = store.answers.begin()->second;
    const std::string good = answer;
    for (std::size_t size = 0; size < good.size(); size += 7)
        CHECK_FALSE(unpacked_translation(good.substr(0, size)).has_value());
    CHECK_FALSE(unpacked_translation(good + "!").has_value());
    for (const std::string& bad : {std::string(), good.substr(0, good.size() / 2), good + "more"}) {
        answer = bad;
        CheckCache cache(&store);
        CHECK(cache.translate(vulkan_vertex, vulkan_fragment).has_value());
        CHECK(cache.compilations() == 1);
        CHECK(answer == good);
    }
}

TEST_CASE("a corrupt size never makes a result larger than its bytes") {
    const auto translation = translate_from_vulkan(vulkan_vertex, vulkan_fragment);
    REQUIRE(translation.has_value());
    const std::string good = packed(*translation);
    for (std::size_t at = 0; at < good.size(); ++at) {
        std::string bad = good;
        bad[at] = static_cast<char>(0xff);
        if (const auto read = unpacked_translation(bad))
            CHECK(read->vertex.text->size() + read->fragment.text->size() <= good.size());
    }
}
