#pragma once

#include "base/diagnostic.h"
#include "gpu/name.h"
#include "model/extent.h"
#include "model/format.h"

#include <cstdint>
#include <span>

namespace gpu {

void delete_texture(GLuint id);

/// A two-dimensional texture, perhaps with its smaller levels. Its row 0 is the bottom one.
class Texture {
public:
    /// Memory for every level; what it holds is undefined. Fails where the machine has not got it.
    static Result<Texture> make(Extent extent, Format format, bool is_mipmapped = false);

    Extent extent() const { return m_extent; }
    Format format() const { return m_format; }
    bool is_mipmapped() const { return m_is_mipmapped; }
    GLuint id() const { return m_name.get(); }
    /// As a toolkit that draws textures takes it.
    std::uintptr_t handle() const { return m_name.get(); }

    /// RGBA floats, the bottom row first, extent.width * extent.height * 4 of them; channels that
    /// the format lacks are dropped. Not for integer formats.
    void upload(std::span<const float> texels);
    /// The smaller levels from the largest; nothing where there are none.
    void generate_mipmaps();

private:
    Texture(Extent extent, Format format, bool is_mipmapped);

    Name<delete_texture> m_name;
    Extent m_extent;
    Format m_format;
    bool m_is_mipmapped;
};

}  // namespace gpu
