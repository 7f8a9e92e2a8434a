#include "gpu/objects/mip_levels.h"

#include "gpu/objects/canvas.h"

#include <algorithm>

namespace gpu {

namespace {
GLuint new_end() {
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    return id;
}

// The read and draw framebuffers.
struct Ends {
    Name<delete_framebuffer> from{new_end()};
    Name<delete_framebuffer> to{new_end()};
};

// Sets a capability of the context for its lifetime.
class SwitchScope {
public:
    SwitchScope(GLenum what, bool is_on) : m_what(what), m_was_on(glIsEnabled(what) == GL_TRUE) {
        set(is_on);
    }
    ~SwitchScope() { set(m_was_on); }
    SwitchScope(const SwitchScope&) = delete;
    SwitchScope& operator=(const SwitchScope&) = delete;

private:
    void set(bool is_on) const { is_on ? glEnable(m_what) : glDisable(m_what); }

    GLenum m_what;
    bool m_was_on;
};

Extent extent_of(const Texture& texture, int level) {
    return {std::max(1, texture.extent().width >> level),
            std::max(1, texture.extent().height >> level)};
}

bool attach(GLenum where, const Name<delete_framebuffer>& end, const Texture& texture, GLenum face,
            int level) {
    glBindFramebuffer(where, end.get());
    glFramebufferTexture2D(where, GL_COLOR_ATTACHMENT0, face, texture.id(), level);
    return glCheckFramebufferStatus(where) == GL_FRAMEBUFFER_COMPLETE;
}

bool draw_face(const Ends& ends, const Texture& texture, GLenum face) {
    for (int level = 1; level < texture.levels(); ++level) {
        if (!attach(GL_READ_FRAMEBUFFER, ends.from, texture, face, level - 1) ||
            !attach(GL_DRAW_FRAMEBUFFER, ends.to, texture, face, level))
            return false;
        const Extent from = extent_of(texture, level - 1);
        const Extent to = extent_of(texture, level);
        glBlitFramebuffer(0, 0, from.width, from.height, 0, 0, to.width, to.height,
                          GL_COLOR_BUFFER_BIT, GL_LINEAR);
    }
    return true;
}
}  // namespace

bool draw_mip_levels(const Texture& texture) {
    constexpr int faces = 6;
    if (texture.shape() == PictureShape::volume)
        return false;
    const bool is_cube = texture.shape() == PictureShape::cube;
    const SwitchScope decoding(GL_FRAMEBUFFER_SRGB, true);
    const SwitchScope limit(GL_SCISSOR_TEST, false);
    const Ends ends;
    bool is_drawn = true;
    for (int face = 0; is_drawn && face < (is_cube ? faces : 1); ++face)
        is_drawn = draw_face(
            ends, texture,
            is_cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face) : GL_TEXTURE_2D);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return is_drawn;
}

}  // namespace gpu
