#include "graph/texel_reader.h"

#include "gpu/draw.h"
#include "graph/measuring.h"
#include "graph/texel_text.h"

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

Result<gpu::Program> build_reader(const std::string& reading) {
    return build_measuring_program(reader_start + reading + reader_end);
}
}  // namespace

Result<TexelReader> TexelReader::make() {
    auto floats = build_reader(float_texel_text);
    if (!floats)
        return fail(floats.error());
    auto naturals = build_reader(natural_texel_text);
    if (!naturals)
        return fail(naturals.error());
    return TexelReader(std::move(*floats), std::move(*naturals));
}

bool TexelReader::draw(const gpu::Texture& from, const TexelRows& rows,
                       std::optional<gpu::Canvas>& to) {
    if (rows.count.is_empty() || !fit_floats(to, rows.count))
        return false;
    const gpu::DrawScope scope;
    const gpu::Program& program = facts_of(from.format()).is_integer ? m_naturals : m_floats;
    program.write("first", rows.first);
    program.write("across", rows.across);
    program.write("down", rows.down);
    program.use();
    m_samplers.bind(0, from, {Filter::nearest, Wrap::edge, false});
    to->bind();
    m_vertices.bind();
    gpu::draw_triangle();
    m_samplers.release();
    return true;
}

void TexelAnswer::ask(TexelReader& reader, const gpu::Texture& from, const TexelRows& rows) {
    stop();
    if (reader.draw(from, rows, m_canvas))
        m_to_come.emplace(*m_canvas);
}

std::optional<std::vector<std::array<float, 4>>> TexelAnswer::take() {
    return take_texels(m_to_come);
}
