#include "gpu/error_log.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <utility>

namespace gpu {

namespace {
void GLAPIENTRY keep_error(GLenum source, GLenum type, GLuint, GLenum, GLsizei length,
                           const GLchar* message, const void* kept) {
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER)  // shader errors are a Result
        return;
    if (type != GL_DEBUG_TYPE_ERROR && type != GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR)
        return;
    // GL returns the pointer as const; it was passed as a pointer to the log's list.
    auto* messages = static_cast<std::vector<std::string>*>(const_cast<void*>(kept));
    messages->emplace_back(message, static_cast<std::size_t>(length));
}
}  // namespace

ErrorLog::ErrorLog() : m_is_listening(epoxy_has_gl_extension("GL_KHR_debug")) {
    if (!m_is_listening)
        return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(keep_error, &m_messages);
}

ErrorLog::~ErrorLog() {
    if (!m_is_listening)
        return;
    glDebugMessageCallback(nullptr, nullptr);
    glDisable(GL_DEBUG_OUTPUT);
}

std::vector<std::string> ErrorLog::take() {
    for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
        if (!m_is_listening)
            m_messages.push_back(fmt::format("GL error {:#06x}", error));
    return std::exchange(m_messages, {});
}

}  // namespace gpu
