#pragma once

#include "base/diagnostic.h"
#include "gpu/objects/name.h"
#include "model/look/extent.h"
#include "model/look/format.h"
#include "model/look/picture.h"

#include <cstdint>
#include <span>

namespace gpu {

void delete_texture(GLuint id);

/// A texture, optionally with mip levels: 2D, a cube or a volume. Row 0 is the bottom row.
class Texture {
public:
    /// Allocates all levels with undefined contents. Fails if the driver can't create the texture.
    static Result<Texture> make(Extent extent, Format format, bool is_mipmapped = false);
    /// A cube or volume whose faces or slices have `side` x `side` texels.
    static Result<Texture> make_solid(PictureShape shape, int side, Format format,
                                      bool is_mipmapped = false);

    /// The size of a cube's face or a volume's slice.
    Extent extent() const { return m_extent; }
    PictureShape shape() const { return m_shape; }
    GLenum target() const;
    Format format() const { return m_format; }
    bool is_mipmapped() const { return m_is_mipmapped; }
    int levels() const;
    GLuint id() const { return m_name.get(); }
    /// The name in the type that a UI toolkit expects.
    std::uintptr_t handle() const { return m_name.get(); }

    /// RGBA floats, bottom row first, extent.width * extent.height * 4 per face or slice. Channels
    /// that the format lacks are dropped. Not for integer formats.
    void upload(std::span<const float> texels);
    /// Draws the smaller levels from the largest; does nothing without mip levels.
    void generate_mipmaps() const;

private:
    Texture(PictureShape shape, Extent extent, Format format, bool is_mipmapped);
    static Result<Texture> allocated(Texture texture);
    void allocate() const;
    void allocate_level(int level, const Extent& extent) const;
    void set_own_sampling(int levels) const;
    std::size_t layers() const;

    Name<delete_texture> m_name;
    PictureShape m_shape;
    Extent m_extent;
    Format m_format;
    bool m_is_mipmapped;
};

}  // namespace gpu
