#pragma once

#include "gpu/objects/name.h"

#include <cstddef>
#include <span>

namespace gpu {

GLuint new_buffer();
void delete_buffer(GLuint id);

/// Vertices that are rewritten each frame.
class StreamBuffer {
public:
    StreamBuffer();

    GLuint id() const { return m_name.get(); }
    /// Replaces the contents. The driver may still draw the previous vertices from their own
    /// memory.
    void write(std::span<const std::byte> bytes);

private:
    Name<delete_buffer> m_name;
    std::size_t m_capacity = 0;
};

}  // namespace gpu
