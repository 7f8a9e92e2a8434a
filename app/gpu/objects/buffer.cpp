#include "gpu/objects/buffer.h"

#include <algorithm>

namespace gpu {

void delete_buffer(GLuint id) {
    glDeleteBuffers(1, &id);
}

GLuint new_buffer() {
    GLuint id = 0;
    glGenBuffers(1, &id);
    return id;
}

StreamBuffer::StreamBuffer() : m_name(new_buffer()) {}

void StreamBuffer::write(std::span<const std::byte> bytes) {
    if (bytes.empty())
        return;
    if (bytes.size() > m_capacity)
        m_capacity = std::max(bytes.size(), m_capacity * 2);
    glBindBuffer(GL_ARRAY_BUFFER, id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(m_capacity), nullptr, GL_STREAM_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes.size()), bytes.data());
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

}  // namespace gpu
