#pragma once

#include "gpu/objects/texture.h"

#include <array>
#include <utility>

namespace gpu {

void delete_framebuffer(GLuint id);

/// A texture that can be drawn into. Belongs to the context that made it.
class Canvas {
public:
    /// Every texel is zero.
    static Result<Canvas> make(Extent extent, Format format, bool is_mipmapped = false);

    const Texture& texture() const { return m_texture; }
    Texture& texture() { return m_texture; }
    /// Alone it belongs to no context.
    Texture take_texture() && { return std::move(m_texture); }

    /// From here on draws go to the whole of it.
    void bind() const;
    /// The same to a rectangle of it, whose lowest left texel is (x, y).
    void bind_part(int x, int y, Extent part) const;
    /// Every texel of the largest level; integer formats take the whole part.
    void clear(std::array<float, 4> rgba = {}) const;
    /// Copies the largest level to a canvas of the same size and format.
    void copy_to(const Canvas& other) const;
    /// The same to a canvas of another size and the same format, linearly filtered.
    void stretch_to(const Canvas& other) const;
    /// Copies six squares, side by side, to the faces of a cube of the same format. Where draws go
    /// stays as it is.
    void copy_faces_to(const Texture& cube) const;

private:
    explicit Canvas(Texture texture);
    void blit_to(const Canvas& other, GLenum filter) const;

    Texture m_texture;
    Name<delete_framebuffer> m_name;
};

}  // namespace gpu
