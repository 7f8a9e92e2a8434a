#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace gpu {

/// Owns the name of one GL object. The destructor needs the context that made the object, or one
/// that shares with it, to be current.
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
        if (m_id != 0)  // a moved-from name needs no context
            Delete(m_id);
    }
    GLuint get() const { return m_id; }

private:
    GLuint m_id;
};

}  // namespace gpu
