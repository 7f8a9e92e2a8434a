#include "graph/targets/pass_through.h"

#include "gpu/objects/draw.h"

#include <fmt/format.h>

#include <array>
#include <string>

namespace {
constexpr const char* through_vertex = R"(#version 410 core
uniform bool is_flipped;
out vec2 uv;
void main() {
    uv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
    uv.y = is_flipped ? 1.0 - uv.y : uv.y;
}
)";

// Clamps to the range of the written kind: no negative naturals, no integers above 0x7fffffff.
std::string held_text(SampleKind read, SampleKind written) {
    std::string numbers = "texture(image, uv)";
    if (written == SampleKind::unsigned_integer && read != SampleKind::unsigned_integer)
        return fmt::format("max({}, {}vec4(0))", numbers, glsl_prefix(read));
    if (written == SampleKind::integer && read == SampleKind::unsigned_integer)
        return fmt::format("min({}, 0x7fffffffu)", numbers);
    return numbers;
}

Result<gpu::Program> build_through(SampleKind read, SampleKind written) {
    const std::string fragment =
        fmt::format(R"(#version 410 core
in vec2 uv;
uniform {0}sampler2D image;
out {1}vec4 color;
void main() {{ color = {1}vec4({2}); }}
)",
                    glsl_prefix(read), glsl_prefix(written), held_text(read, written));
    return gpu::Program::build({{}, through_vertex, {}}, {{}, fragment, {}});
}
}  // namespace

Result<PassThroughPrograms> build_pass_through() {
    PassThroughPrograms programs;
    for (const SampleKind written :
         {SampleKind::floating, SampleKind::unsigned_integer, SampleKind::integer}) {
        auto into = SamplePrograms::make(
            [written](SampleKind read) { return build_through(read, written); });
        if (!into)
            return fail(into.error());
        programs.push_back(std::move(*into));
    }
    return programs;
}

Result<PassThrough> PassThrough::make() {
    auto programs = build_pass_through();
    if (!programs)
        return fail(programs.error());
    return PassThrough(std::make_shared<const PassThroughPrograms>(std::move(*programs)));
}

void PassThrough::draw(const gpu::Texture& from, const Sampler& sampler, const gpu::Canvas& to,
                       gpu::Samplers& samplers, bool is_flipped) const {
    const auto written = static_cast<std::size_t>(sample_kind_of(to.texture().format()));
    const gpu::Program* found = (*m_programs)[written].find(from.format());
    if (!found)
        return;
    const gpu::Program& program = *found;
    program.write("is_flipped", std::array{is_flipped ? 1.0 : 0.0});
    program.use();
    samplers.bind(0, from, sampler);
    to.bind();
    gpu::set_blend(Blend::replace);
    m_vertices.bind();
    gpu::draw_triangle();
}
