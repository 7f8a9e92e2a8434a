#include "graph/gatherer.h"

#include "gpu/draw.h"
#include "graph/measuring.h"
#include "graph/texel_text.h"

namespace {
constexpr const char* gather_start = R"(#version 410 core
out vec4 color;
uniform ivec2 place;  // texel, from the bottom left
)";

constexpr const char* gather_end = R"(
void main() { color = texel_at(place); }
)";

Result<gpu::Program> build_gatherer(const std::string& reading) {
    return build_measuring_program(gather_start + reading + gather_end);
}
}  // namespace

Gatherer::Gatherer(gpu::Program floats, gpu::Program naturals)
    : m_floats(std::move(floats)), m_naturals(std::move(naturals)) {}

Result<Gatherer> Gatherer::make() {
    auto floats = build_gatherer(float_texel_text);
    if (!floats)
        return fail(floats.error());
    auto naturals = build_gatherer(natural_texel_text);
    if (!naturals)
        return fail(naturals.error());
    return Gatherer(std::move(*floats), std::move(*naturals));
}

void Gatherer::start(const std::vector<TexelPlace>& places) {
    stop();
    const Extent row{static_cast<int>(places.size()), 1};
    if (places.empty() || !fit_floats(m_canvas, row))
        return;
    const gpu::DrawScope scope;
    m_vertices.bind();
    for (int i = 0; i < row.width; ++i) {
        const TexelPlace& one = places[static_cast<std::size_t>(i)];
        const Extent extent = one.target.extent();
        const gpu::Program& program =
            facts_of(one.target.format()).is_integer ? m_naturals : m_floats;
        program.write("place",
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

std::optional<std::vector<std::array<float, 4>>> Gatherer::take() {
    return take_texels(m_to_come);
}
