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

/// A texture, perhaps with its smaller levels: of two dimensions, a cube or a volume. Its row 0 is
/// the bottom one.
class Texture {
public:
    /// Memory for every level; what it holds is undefined. Fails where the machine has not got it.
    static Result<Texture> make(Extent extent, Format format, bool is_mipmapped = false);
    /// A cube or volume, a face or slice of which is so many texels wide and high.
    static Result<Texture> make_solid(PictureShape shape, int side, Format format,
                                      bool is_mipmapped = false);

    /// Of a cube's face, of a volume's slice.
    Extent extent() const { return m_extent; }
    PictureShape shape() const { return m_shape; }
    GLenum target() const;
    Format format() const { return m_format; }
    bool is_mipmapped() const { return m_is_mipmapped; }
    int levels() const;
    GLuint id() const { return m_name.get(); }
    /// As a toolkit that draws textures takes it.
    std::uintptr_t handle() const { return m_name.get(); }

    /// RGBA floats, the bottom row first, extent.width * extent.height * 4 of them a face or
    /// slice; channels that the format lacks are dropped. Not for integer formats.
    void upload(std::span<const float> texels);
    /// The smaller levels from the largest; nothing where there are none.
    void generate_mipmaps();

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
