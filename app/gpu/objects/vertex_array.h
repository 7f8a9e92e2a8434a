#pragma once

#include "gpu/objects/buffer.h"

namespace gpu {

void delete_vertex_array(GLuint id);

/// The layout of one vertex attribute in a buffer of floats.
struct Attribute {
    int location = -1;  // below 0: not in the program; ignored
    int components = 1;
    int stride = 0;  // bytes from one vertex or instance to the next
    int offset = 0;  // bytes
    bool is_per_instance = false;
};

/// The attributes of one draw. A core profile needs one bound even without attributes.
class VertexArray {
public:
    VertexArray();

    void set(const Attribute& attribute, const StreamBuffer& buffer);
    /// Reads the attribute from its buffer, or sets all its components to 1. Binds the array.
    void choose(int location, bool is_from_buffer) const;
    void bind() const { glBindVertexArray(m_name.get()); }

private:
    Name<delete_vertex_array> m_name;
};

}  // namespace gpu
