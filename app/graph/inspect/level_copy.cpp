#include "graph/inspect/level_copy.h"

#include "gpu/objects/draw.h"
#include "graph/inspect/texel_programs.h"

#include <algorithm>
#include <array>

namespace {
constexpr const char* level_fragment = R"(#version 410 core
uniform sampler2D image;
uniform int level;
out vec4 color;
void main() { color = texelFetch(image, ivec2(gl_FragCoord.xy), level); }
)";
}  // namespace

int level_count(const gpu::Texture& texture) {
    int count = 1;
    if (texture.is_mipmapped())
        for (int side = std::max(texture.extent().width, texture.extent().height); side > 1;
             side /= 2)
            ++count;
    return count;
}

Extent level_extent(Extent largest, int level) {
    return {std::max(largest.width >> level, 1), std::max(largest.height >> level, 1)};
}

Result<LevelCopy> LevelCopy::make() {
    auto program = build_measuring_program(level_fragment);
    if (!program)
        return fail(program.error());
    return LevelCopy(std::move(*program));
}

const gpu::Texture* LevelCopy::draw(const gpu::Texture& from, int level) {
    const Format format = from.format() == Format::srgb8_alpha8 ? Format::rgba32f : from.format();
    const bool is_there = level >= 0 && level < level_count(from) && !info_of(format).is_integer;
    if (!is_there || !fit_canvas(m_canvas, level_extent(from.extent(), level), format))
        return nullptr;
    const gpu::DrawScope scope;
    m_program.write("level", std::array{static_cast<double>(level)});
    m_program.use();
    m_samplers.bind(0, from, {Filter::nearest, Wrap::edge, true});
    m_canvas->bind();
    m_vertices.bind();
    gpu::draw_triangle();
    m_samplers.release();
    return &m_canvas->texture();
}
