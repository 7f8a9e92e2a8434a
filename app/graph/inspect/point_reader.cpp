#include "graph/inspect/point_reader.h"

#include "gpu/objects/draw.h"
#include "graph/inspect/texel_programs.h"

#include <algorithm>

namespace {
constexpr const char* gather_start = R"(#version 410 core
out vec4 color;
uniform ivec2 texel;  // from the bottom left
)";

constexpr const char* gather_end = R"(
void main() { color = texel_at(texel); }
)";
}  // namespace

Result<PointReader> PointReader::make() {
    auto programs = build_texel_programs(gather_start, gather_end);
    if (!programs)
        return fail(programs.error());
    return PointReader(std::move(*programs));
}

void PointReader::start(const std::vector<TexelPosition>& positions) {
    stop();
    const Extent row{static_cast<int>(positions.size()), 1};
    const bool can_read = std::ranges::all_of(positions, [this](const TexelPosition& one) {
        return m_programs.find(one.target.format()) != nullptr;
    });
    if (positions.empty() || !can_read || !fit_floats(m_canvas, row))
        return;
    const gpu::DrawScope scope;
    m_vertices.bind();
    for (int i = 0; i < row.width; ++i) {
        const TexelPosition& one = positions[static_cast<std::size_t>(i)];
        const Extent extent = one.target.extent();
        const gpu::Program& program = *m_programs.find(one.target.format());
        program.write("texel",
                      std::array<double, 2>{static_cast<double>(one.x),
                                            static_cast<double>(extent.height - 1 - one.y)});
        program.use();
        m_samplers.bind(0, one.target, {Filter::nearest, Wrap::edge, false});
        m_canvas->bind();
        gpu::limit_columns(i, i + 1);
        gpu::draw_triangle();
    }
    m_samplers.release();
    m_to_come.emplace(*m_canvas);
}

std::optional<std::vector<std::array<float, 4>>> PointReader::take() {
    return take_texels(m_to_come);
}
