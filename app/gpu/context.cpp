#include "gpu/context.h"

#include <epoxy/gl.h>

#include <array>

namespace gpu {

namespace {
std::string text_of(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}
}  // namespace

Facts read_facts() {
    Facts facts{text_of(GL_RENDERER), text_of(GL_VENDOR), text_of(GL_VERSION)};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &facts.largest_texture);
    std::array<GLfloat, 2> sizes{};
    glGetFloatv(GL_POINT_SIZE_RANGE, sizes.data());
    facts.largest_point_size = sizes[1];
    return facts;
}

}  // namespace gpu
