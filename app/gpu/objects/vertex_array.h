#pragma once

#include "gpu/objects/buffer.h"

namespace gpu {

void delete_vertex_array(GLuint id);

/// Where one attribute of a vertex lies in a buffer of floats.
struct Attribute {
    int location = -1;  // below 0: the program has none, nothing is set
    int components = 1;
    int stride = 0;  // bytes from one vertex or instance to the next
    int offset = 0;  // bytes
    bool is_per_instance = false;
};

/// The attributes of one draw; without any it still is what a core profile wants bound.
class VertexArray {
public:
    VertexArray();

    void set(const Attribute& attribute, const StreamBuffer& buffer);
    /// The attribute is read from its buffer again, or is 1 in all its components. Binds.
    void choose(int location, bool is_from_buffer) const;
    void bind() const { glBindVertexArray(m_name.get()); }

private:
    Name<delete_vertex_array> m_name;
};

}  // namespace gpu
