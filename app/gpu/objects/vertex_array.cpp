#include "gpu/objects/vertex_array.h"

namespace gpu {

void delete_vertex_array(GLuint id) {
    glDeleteVertexArrays(1, &id);
}

namespace {
GLuint new_vertex_array() {
    GLuint id = 0;
    glGenVertexArrays(1, &id);
    return id;
}
}  // namespace

VertexArray::VertexArray() : m_name(new_vertex_array()) {}

void VertexArray::set(const Attribute& attribute, const StreamBuffer& buffer) {
    if (attribute.location < 0)
        return;
    const auto location = static_cast<GLuint>(attribute.location);
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(
        location, attribute.components, GL_FLOAT, GL_FALSE, attribute.stride,
        reinterpret_cast<const void*>(static_cast<std::size_t>(attribute.offset)));
    glVertexAttribDivisor(location, attribute.is_per_instance ? 1 : 0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindVertexArray(0);
}

void VertexArray::choose(int location, bool is_from_buffer) const {
    bind();
    const auto attribute = static_cast<GLuint>(location);
    if (is_from_buffer) {
        glEnableVertexAttribArray(attribute);
        return;
    }
    glDisableVertexAttribArray(attribute);
    glVertexAttrib4f(attribute, 1.0f, 1.0f, 1.0f, 1.0f);
}

}  // namespace gpu
