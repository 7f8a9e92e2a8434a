#include "gpu/context.h"

#include "gpu/program.h"
#include "gpu/renderdoc.h"

#include <epoxy/gl.h>

#include <array>
#include <utility>

namespace gpu {

namespace {
std::string text_of(GLenum name) {
    const GLubyte* text = glGetString(name);
    return text ? reinterpret_cast<const char*>(text) : "";
}

thread_local Context* current_context = nullptr;
}  // namespace

namespace {
// GL_EXT_debug_tool is offered only by debuggers such as RenderDoc and apitrace.
bool has_debugger() {
    if (!epoxy_has_gl_extension("GL_KHR_debug"))
        return false;
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    return (flags & GL_CONTEXT_FLAG_DEBUG_BIT) != 0 ||
           epoxy_has_gl_extension("GL_EXT_debug_tool") || has_renderdoc();
}
}  // namespace

DriverInfo read_info() {
    DriverInfo info{text_of(GL_RENDERER), text_of(GL_VENDOR), text_of(GL_VERSION)};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &info.largest_texture);
    std::array<GLfloat, 2> sizes{};
    glGetFloatv(GL_POINT_SIZE_RANGE, sizes.data());
    info.largest_point_size = sizes[1];
    info.is_debugged = has_debugger();
    return info;
}

bool was_reset() {
    if (!epoxy_has_gl_extension("GL_ARB_robustness"))
        return false;
    return glGetGraphicsResetStatusARB() != GL_NO_ERROR;
}

Context::Context() = default;

Context::~Context() {
    if (current_context == this)
        current_context = nullptr;
}

Context* Context::current() {
    return current_context;
}

void Context::make_current() {
    take_thread();
    current_context = this;
    destroy_pending();
}

void Context::release() {
    leave_thread();
    current_context = nullptr;
}

void Context::destroy_later(std::unique_ptr<const Program> object) {
    if (current_context == this)
        return;  // destroyed here
    const std::lock_guard lock(m_mutex);
    m_pending_destruction.push_back(std::move(object));
}

void Context::destroy_pending() {
    std::vector<std::unique_ptr<const Program>> buried;
    const std::lock_guard lock(m_mutex);
    buried.swap(m_pending_destruction);
}

namespace {
// Commands of the current context complete before later commands of `to`.
void hand_over_to(Context& to) {
    const GLsync done = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
    to.make_current();
    glWaitSync(done, 0, GL_TIMEOUT_IGNORED);
    glDeleteSync(done);
}
}  // namespace

ContextScope::ContextScope(Context* context) {
    Context* const before = Context::current();
    if (!context || context == before)
        return;
    m_before = before;
    m_context = context;
    if (m_before)
        hand_over_to(*m_context);
    else
        m_context->make_current();
}

ContextScope::~ContextScope() {
    if (!m_context)
        return;
    if (m_before)
        hand_over_to(*m_before);
    else
        m_context->release();
}

}  // namespace gpu
