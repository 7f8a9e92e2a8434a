#include "graph/inspect/texel_reader.h"

#include "gpu/objects/draw.h"
#include "graph/inspect/texel_programs.h"

namespace {
constexpr const char* reader_start = R"(#version 410 core
out vec4 color;
uniform vec2 first, across, down;  // texels from the top left
)";

constexpr const char* reader_end = R"(
void main() {
    vec2 at = floor(gl_FragCoord.xy);
    ivec2 last = textureSize(shown, 0) - 1;
    ivec2 texel = clamp(ivec2(floor(first + at.x * across + at.y * down)), ivec2(0), last);
    color = texel_at(ivec2(texel.x, last.y - texel.y));
}
)";
}  // namespace

Result<TexelReader> TexelReader::make() {
    auto programs = build_texel_programs(reader_start, reader_end);
    if (!programs)
        return fail(programs.error());
    return TexelReader(std::move(*programs));
}

bool TexelReader::draw(const gpu::Texture& from, const TexelRows& rows,
                       std::optional<gpu::Canvas>& to) {
    const gpu::Program* program = m_programs.find(from.format());
    if (!program || rows.count.is_empty() || !fit_floats(to, rows.count))
        return false;
    const gpu::DrawScope scope;
    program->write("first", rows.first);
    program->write("across", rows.across);
    program->write("down", rows.down);
    program->use();
    m_samplers.bind(0, from, {Filter::nearest, Wrap::edge, false});
    to->bind();
    m_vertices.bind();
    gpu::draw_triangle();
    m_samplers.release();
    return true;
}

void TexelReadback::ask(TexelReader& reader, const gpu::Texture& from, const TexelRows& rows) {
    stop();
    if (reader.draw(from, rows, m_canvas))
        m_to_come.emplace(*m_canvas);
}

std::optional<std::vector<std::array<float, 4>>> TexelReadback::take() {
    return take_texels(m_to_come);
}
