#include "graph/inspect/texel_programs.h"

#include "graph/inspect/texel_text.h"

#include <algorithm>

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

Result<SamplePrograms> build_texel_programs(std::string start, std::string end) {
    return SamplePrograms::make([start = std::move(start), end = std::move(end)](SampleKind kind) {
        return build_measuring_program(start + texel_text(kind) + end);
    });
}

bool fit_canvas(std::optional<gpu::Canvas>& canvas, Extent extent, Format format) {
    if (canvas && canvas->texture().extent() == extent && canvas->texture().format() == format)
        return true;
    canvas.reset();
    auto made = gpu::Canvas::make(extent, format);
    if (made)
        canvas.emplace(std::move(*made));
    return made.has_value();
}

bool fit_floats(std::optional<gpu::Canvas>& canvas, Extent extent) {
    return fit_canvas(canvas, extent, Format::rgba32f);
}

std::optional<std::vector<std::array<float, 4>>> take_texels(
    std::optional<gpu::Download>& to_come) {
    if (!to_come || !to_come->is_available())
        return std::nullopt;
    const std::vector<float> numbers = to_come->take();
    to_come.reset();
    std::vector<std::array<float, 4>> texels(numbers.size() / 4);
    for (std::size_t i = 0; i < texels.size(); ++i)
        std::copy_n(&numbers[i * 4], 4, texels[i].begin());
    return texels;
}
