#include "graph/measuring.h"

namespace {
constexpr const char* vertex_text = R"(#version 410 core
void main() {
    gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0);
}
)";

}  // namespace

Result<gpu::Program> build_measuring_program(const std::string& fragment_text) {
    return gpu::Program::build({{}, vertex_text, {}}, {{}, fragment_text, {}});
}

bool fit_floats(std::optional<gpu::Canvas>& canvas, Extent extent) {
    if (canvas && canvas->texture().extent() == extent)
        return true;
    canvas.reset();
    auto made = gpu::Canvas::make(extent, Format::rgba32f);
    if (made)
        canvas.emplace(std::move(*made));
    return made.has_value();
}
