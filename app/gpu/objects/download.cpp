#include "gpu/objects/download.h"

namespace gpu {

void DeleteFence::operator()(GLsync fence) const {
    glDeleteSync(fence);
}

namespace {
std::size_t floats_of(Extent extent) {
    return static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height) * 4;
}
}  // namespace

Download::Download(const Canvas& from)
    : m_count(floats_of(from.texture().extent())), m_buffer(new_buffer()) {
    const Extent extent = from.texture().extent();
    from.bind();
    glBindBuffer(GL_PIXEL_PACK_BUFFER, m_buffer.get());
    glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(m_count * sizeof(float)), nullptr,
                 GL_STREAM_READ);
    glReadPixels(0, 0, extent.width, extent.height, GL_RGBA, GL_FLOAT, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    m_fence.reset(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
    glFlush();  // otherwise the fence might never be signalled
}

bool Download::is_available() const {
    const GLenum state = glClientWaitSync(m_fence.get(), 0, 0);
    return state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED;
}

std::vector<float> Download::take() {
    std::vector<float> texels(m_count);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, m_buffer.get());
    glGetBufferSubData(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(m_count * sizeof(float)),
                       texels.data());
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    return texels;
}

}  // namespace gpu
