#include "portable_player/shapes.h"

#include <array>
#include <cstddef>

namespace {
GLuint new_buffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return name;
}

GLuint new_vertex_array() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return name;
}

template <class Vertex>
void write(const GlName<delete_buffer>& buffer, const std::vector<Vertex>& vertices) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer.get());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                 vertices.data(), GL_STREAM_DRAW);
}

/// Where vertices have the numbers of an attribute.
struct Attribute {
    GLint location;
    GLint components;
    std::size_t offset;
};

// The buffer must be bound.
void set(const Attribute& attribute, std::size_t stride, GLuint divisor) {
    if (attribute.location < 0)
        return;
    const auto location = static_cast<GLuint>(attribute.location);
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, attribute.components, GL_FLOAT, GL_FALSE,
                          static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(attribute.offset));
    glVertexAttribDivisor(location, divisor);
}
}  // namespace

Shapes::Shapes(const Description& description, const Size& view)
    : m_points(new_buffer()), m_segments(new_buffer()), m_quad(new_buffer()) {
    write(m_quad, std::vector<float>{0, 0, 1, 0, 0, 1, 1, 1});
    if (description.signal.is_null())
        return;
    m_signal = make_signal(description.signal);
    m_beam.emplace(*m_signal, beam_scale(description, view));
}

void Shapes::add_pass(const Pass& pass, const Program& program) {
    Vertices vertices{GlName<delete_vertex_array>(new_vertex_array()), pass.draw};
    glBindVertexArray(vertices.name.get());
    if (pass.draw == "points") {
        glBindBuffer(GL_ARRAY_BUFFER, m_points.get());
        for (const Attribute& attribute :
             {Attribute{program.attribute("position"), 2, offsetof(PointVertex, x)},
              Attribute{program.attribute("intensity"), 1, offsetof(PointVertex, charge)},
              Attribute{program.attribute("age_seconds"), 1, offsetof(PointVertex, age)}})
            set(attribute, sizeof(PointVertex), 0);
    } else if (pass.draw == "segments") {
        glBindBuffer(GL_ARRAY_BUFFER, m_segments.get());
        for (const Attribute& attribute :
             {Attribute{program.attribute("segment"), 4, offsetof(SegmentVertex, x0)},
              Attribute{program.attribute("intensities"), 2, offsetof(SegmentVertex, start_charge)},
              Attribute{program.attribute("ages_seconds"), 2, offsetof(SegmentVertex, start_age)}})
            set(attribute, sizeof(SegmentVertex), 1);
    } else if (pass.draw == "quad") {
        glBindBuffer(GL_ARRAY_BUFFER, m_quad.get());
        set({0, 2, 0}, 2 * sizeof(float), 0);
        set({1, 2, 0}, 2 * sizeof(float), 0);
    }
    m_passes.push_back(std::move(vertices));
}

void Shapes::advance(double start, double end) {
    if (!m_beam)
        return;
    m_beam->advance(start, end);
    write(m_points, m_beam->points());
    write(m_segments, m_beam->segments());
}

void Shapes::draw(std::size_t pass) const {
    const Vertices& vertices = m_passes[pass];
    glBindVertexArray(vertices.name.get());
    if (vertices.draw == "points" && m_beam)
        glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(m_beam->points().size()));
    else if (vertices.draw == "segments" && m_beam)
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4,
                              static_cast<GLsizei>(m_beam->segments().size()));
    else if (vertices.draw == "quad")
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    else if (vertices.draw == "fullscreen")
        glDrawArrays(GL_TRIANGLES, 0, 3);
}
