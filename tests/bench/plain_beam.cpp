#include "bench/plain_beam.h"

#include <cstddef>

namespace bench {

namespace {
constexpr const char* way_vertex = R"(#version 410 core
in vec2 start;
in vec2 end;
in float charge;
uniform vec2 size;
uniform float sigma;
out vec2 at;
flat out float len;
flat out float light;
void main() {
    vec2 from = (0.5 + 0.5 * start) * size;
    vec2 way = (0.5 + 0.5 * end) * size - from;
    len = length(way);
    light = charge;
    vec2 ahead = len > 1e-6 ? way / len : vec2(1.0, 0.0);
    float reach = 5.0 * sigma;
    at = vec2((gl_VertexID & 1) == 0 ? -reach : len + reach, (gl_VertexID & 2) == 0 ? -reach : reach);
    vec2 place = from + at.x * ahead + at.y * vec2(-ahead.y, ahead.x);
    gl_Position = vec4(2.0 * place / size - 1.0, 0.0, 1.0);
}
)";

// The error function by a rational approximation (Abramowitz and Stegun 7.1.27), error at most
// 5e-4.
constexpr const char* way_fragment = R"(#version 410 core
uniform float sigma;
in vec2 at;
flat in float len;
flat in float light;
out vec4 color;
vec2 erf2(vec2 x) {
    vec2 a = abs(x);
    vec2 y = 1.0 + (0.278393 + (0.230389 + (0.000972 + 0.078108 * a) * a) * a) * a;
    y *= y;
    return sign(x) * (1.0 - 1.0 / (y * y));
}
void main() {
    float across = exp(-at.y * at.y / (2.0 * sigma * sigma)) / (2.50662827 * sigma);
    float along;
    if (len < 1e-4) {
        along = exp(-at.x * at.x / (2.0 * sigma * sigma)) / (2.50662827 * sigma);
    } else {
        vec2 sides = erf2(vec2(at.x, at.x - len) / (1.41421356 * sigma));
        along = 0.5 * (sides.x - sides.y) / len;
    }
    color = vec4(light * across * along);
}
)";

Stage stage_with(const char* text) {
    Stage stage;
    stage.text = text;
    return stage;
}
}  // namespace

PlainBeam::PlainBeam(Extent extent, gpu::Program program)
    : m_target(std::make_unique<plain::Surface>(extent, GL_RGBA32F, false)),
      m_program(std::move(program)) {
    GLuint id = 0;
    glGenBuffers(1, &id);
    m_buffer.emplace_back(id);
    glGenVertexArrays(1, &id);
    m_vertices.emplace_back(id);
    glBindVertexArray(id);
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer.front().get());
    const auto attribute = [&](const char* name, GLint components, std::size_t offset) {
        const auto at = static_cast<GLuint>(m_program.attribute_location(name));
        glEnableVertexAttribArray(at);
        glVertexAttribPointer(at, components, GL_FLOAT, GL_FALSE, sizeof(BeamPoint),
                              reinterpret_cast<const void*>(offset));
        glVertexAttribDivisor(at, 1);
    };
    attribute("start", 2, 0);
    attribute("end", 2, sizeof(BeamPoint));
    attribute("charge", 1, sizeof(BeamPoint) + offsetof(BeamPoint, intensity));
}

Result<PlainBeam> PlainBeam::make(Extent extent, double sigma) {
    auto program = gpu::Program::build(stage_with(way_vertex), stage_with(way_fragment));
    if (!program)
        return fail(program.error());
    program->write("size", std::vector<double>{1.0 * extent.width, 1.0 * extent.height});
    program->write("sigma", std::vector<double>{sigma});
    return PlainBeam(extent, std::move(*program));
}

void PlainBeam::draw(std::span<const BeamPoint> points) {
    m_target->begin();
    m_program.use();
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
    glBindVertexArray(m_vertices.front().get());
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer.front().get());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size_bytes()), points.data(),
                 GL_STREAM_DRAW);
    if (points.size() > 1)
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(points.size() - 1));
    glDisable(GL_BLEND);
}

Picture PlainBeam::picture() const {
    const Extent extent = m_target->extent();
    const std::vector<float> texels = m_target->read();
    Picture picture{extent, 4, Encoding::linear, {}};
    const auto row = static_cast<std::ptrdiff_t>(extent.width) * 4;
    for (auto end = texels.end(); end != texels.begin(); end -= row)
        picture.pixels.insert(picture.pixels.end(), end - row, end);
    return picture;
}

}  // namespace bench
