#include "graph/pass_through.h"

#include "gpu/draw.h"

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

std::string fragment_text(bool from_naturals, bool to_naturals) {
    const std::string read = "texture(image, uv)";
    return std::string("#version 410 core\nin vec2 uv;\nuniform ") +
           (from_naturals ? "usampler2D" : "sampler2D") + " image;\nout " +
           (to_naturals ? "uvec4" : "vec4") + " color;\nvoid main() { color = " +
           (to_naturals ? "uvec4(" + (from_naturals ? read : "max(" + read + ", 0.0)") + ")"
                        : "vec4(" + read + ")") +
           "; }\n";
}
}  // namespace

Result<PassThroughPrograms> build_pass_through() {
    PassThroughPrograms programs;
    for (const bool to_naturals : {false, true})
        for (const bool from_naturals : {false, true}) {
            auto program = gpu::Program::build({{}, through_vertex, {}},
                                               {{}, fragment_text(from_naturals, to_naturals), {}});
            if (!program)
                return fail(program.error());
            programs.push_back(std::move(*program));
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
    const bool from_naturals = facts_of(from.format()).is_integer;
    const bool to_naturals = facts_of(to.texture().format()).is_integer;
    const gpu::Program& program =
        (*m_programs)[(to_naturals ? 2U : 0U) + (from_naturals ? 1U : 0U)];
    program.write("is_flipped", std::array{is_flipped ? 1.0 : 0.0});
    program.use();
    samplers.bind(0, from, sampler);
    to.bind();
    gpu::set_blend(Blend::replace);
    m_vertices.bind();
    gpu::draw_triangle();
}
