#pragma once

#include "gpu/objects/texture.h"

#include <array>
#include <utility>

namespace gpu {

void delete_framebuffer(GLuint id);

/// A texture that can be a render target. Belongs to the context that made it.
class Canvas {
public:
    /// All texels are zero.
    static Result<Canvas> make(Extent extent, Format format, bool is_mipmapped = false);

    const Texture& texture() const { return m_texture; }
    Texture& texture() { return m_texture; }
    /// A texture alone does not belong to a context.
    Texture take_texture() && { return std::move(m_texture); }
    GLuint framebuffer() const { return m_name.get(); }

    /// Subsequent draws go to the whole canvas.
    void bind() const;
    /// Subsequent draws go to a rectangle, whose bottom left texel is (x, y).
    void bind_part(int x, int y, Extent part) const;
    /// Clears all texels of the largest level; integer formats take the integer part.
    void clear(std::array<float, 4> rgba = {}) const;
    /// Copies the largest level to a canvas of the same size and format.
    void copy_to(const Canvas& other) const;
    /// Copies to a canvas of another size and the same format, with linear filtering.
    void stretch_to(const Canvas& other) const;
    /// Copies six squares, stacked vertically, to the faces of a cube of the same format. The draw
    /// framebuffer stays bound.
    void copy_faces_to(const Texture& cube) const;

private:
    explicit Canvas(Texture texture);
    void blit_to(const Canvas& other, GLenum filter) const;

    Texture m_texture;
    Name<delete_framebuffer> m_name;
};

}  // namespace gpu
