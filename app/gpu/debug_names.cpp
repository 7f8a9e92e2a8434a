#include "gpu/debug_names.h"

#include "gpu/context.h"
#include "gpu/objects/canvas.h"
#include "gpu/program.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace gpu {

namespace {
// GL_MAX_LABEL_LENGTH and GL_MAX_DEBUG_MESSAGE_LENGTH are at least 256 in Mesa and NVIDIA's driver.
constexpr std::size_t longest_name = 255;

GLsizei length_of(std::string_view name) {
    return static_cast<GLsizei>(std::min(name.size(), longest_name));
}

void label_object(GLenum kind, GLuint id, std::string_view name) {
    if (is_debugged())
        glObjectLabel(kind, id, length_of(name), name.data());
}
}  // namespace

bool is_debugged() {
    const Context* context = Context::current();
    return context && context->info().is_debugged;
}

void set_label(const Texture& texture, std::string_view name) {
    label_object(GL_TEXTURE, texture.id(), name);
}

void set_label(const Canvas& canvas, std::string_view name) {
    set_label(canvas.texture(), name);
    label_object(GL_FRAMEBUFFER, canvas.framebuffer(), name);
}

void set_label(const Program& program, std::string_view name) {
    label_object(GL_PROGRAM, program.id(), name);
}

DebugGroup::DebugGroup(std::string_view name) : m_is_open(is_debugged()) {
    if (m_is_open)
        glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, length_of(name), name.data());
}

DebugGroup::~DebugGroup() {
    if (m_is_open)
        glPopDebugGroup();
}

}  // namespace gpu
