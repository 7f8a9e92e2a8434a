#include "gpu/objects/canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace gpu {

void delete_framebuffer(GLuint id) {
    glDeleteFramebuffers(1, &id);
}

namespace {
GLuint new_framebuffer() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
}
}  // namespace

Canvas::Canvas(Texture texture) : m_texture(std::move(texture)), m_name(new_framebuffer()) {}

Result<Canvas> Canvas::make(Extent extent, Format format, bool is_mipmapped) {
    auto texture = Texture::make(extent, format, is_mipmapped);
    if (!texture)
        return fail(texture.error());
    Canvas canvas(std::move(*texture));
    // Each level is cleared separately: when glGenerateMipmap runs on new memory, Mesa 22 loses the
    // first draw into it.
    for (int level = canvas.m_texture.levels() - 1; level >= 0; --level) {
        glBindFramebuffer(GL_FRAMEBUFFER, canvas.m_name.get());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                               canvas.m_texture.id(), level);
        const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
        if (status != GL_FRAMEBUFFER_COMPLETE) {
            glBindFramebuffer(GL_FRAMEBUFFER, 0);
            return fail({{},
                         0,
                         fmt::format("the graphics driver can't render to the format {} ({:#x})",
                                     info_of(format).name, status)});
        }
        canvas.clear();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return canvas;
}

void Canvas::bind() const {
    bind_part(0, 0, m_texture.extent());
}

void Canvas::bind_part(int x, int y, Extent part) const {
    glBindFramebuffer(GL_FRAMEBUFFER, m_name.get());
    glViewport(x, y, part.width, part.height);
}

namespace {
// The integer part, clamped to the range of the type.
template <class Whole>
std::array<Whole, 4> whole_parts(const std::array<float, 4>& rgba) {
    const auto minimum = static_cast<double>(std::numeric_limits<Whole>::lowest());
    const auto maximum = static_cast<double>(std::numeric_limits<Whole>::max());
    std::array<Whole, 4> whole{};
    std::ranges::transform(rgba, whole.begin(), [minimum, maximum](float number) {
        return static_cast<Whole>(std::clamp(static_cast<double>(number), minimum, maximum));
    });
    return whole;
}
}  // namespace

void Canvas::clear(std::array<float, 4> rgba) const {
    bind();
    glDisable(GL_SCISSOR_TEST);
    switch (sample_kind_of(m_texture.format())) {
        case SampleKind::floating:
            return glClearBufferfv(GL_COLOR, 0, rgba.data());
        case SampleKind::unsigned_integer:
            return glClearBufferuiv(GL_COLOR, 0, whole_parts<GLuint>(rgba).data());
        case SampleKind::integer:
            return glClearBufferiv(GL_COLOR, 0, whole_parts<GLint>(rgba).data());
    }
}

void Canvas::copy_to(const Canvas& other) const {
    blit_to(other, GL_NEAREST);
}

void Canvas::stretch_to(const Canvas& other) const {
    blit_to(other, GL_LINEAR);
}

void Canvas::blit_to(const Canvas& other, GLenum filter) const {
    const Extent from = m_texture.extent();
    const Extent to = other.m_texture.extent();
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_name.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, other.m_name.get());
    glBlitFramebuffer(0, 0, from.width, from.height, 0, 0, to.width, to.height, GL_COLOR_BUFFER_BIT,
                      filter);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Canvas::copy_faces_to(const Texture& cube) const {
    constexpr int faces = 6;
    const int side = cube.extent().width;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_name.get());
    glBindTexture(cube.target(), cube.id());
    for (int face = 0; face < faces; ++face)
        glCopyTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), 0, 0, 0,
                            face * side, 0, side, side);
    glBindTexture(cube.target(), 0);
}

}  // namespace gpu
