#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace gpu {

/// Owns the name of one GL object. The context that made it, or one that shares with it, is current
/// when the owner ends.
template <void (*Delete)(GLuint)>
class Name {
public:
    explicit Name(GLuint id) : m_id(id) {}
    Name(Name&& other) noexcept : m_id(std::exchange(other.m_id, 0)) {}
    Name& operator=(Name&& other) noexcept {
        std::swap(m_id, other.m_id);
        return *this;
    }
    ~Name() {
        if (m_id != 0)  // what was moved from may end without a context
            Delete(m_id);
    }
    GLuint get() const { return m_id; }

private:
    GLuint m_id;
};

}  // namespace gpu
