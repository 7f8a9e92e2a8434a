#include "gpu/objects/texture.h"

#include "gpu/objects/gl_format.h"
#include "gpu/objects/mip_levels.h"
#include "gpu/objects/upload_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <vector>

namespace gpu {

void delete_texture(GLuint id) {
    glDeleteTextures(1, &id);
}

namespace {
GLuint new_texture() {
    GLuint id = 0;
    glGenTextures(1, &id);
    return id;
}

// A proxy texture: an allocation above the limit would raise a GL error.
bool is_possible(Extent extent, const GlFormat& format) {
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, format.internal, extent.width, extent.height, 0,
                 format.layout, format.type, nullptr);
    GLint width = 0;
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    return width == extent.width;
}

// Bounded: a lost context reports errors endlessly.
void forget_errors() {
    for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
    }
}

tl::unexpected<Diagnostics> no_memory(Extent extent, Format format) {
    return fail(
        {{},
         0,
         fmt::format("the graphics driver can't create a {} x {} px texture in the format {}",
                     extent.width, extent.height, info_of(format).name)});
}
}  // namespace

Texture::Texture(PictureShape shape, Extent extent, Format format, bool is_mipmapped)
    : m_name(new_texture()),
      m_shape(shape),
      m_extent(extent),
      m_format(format),
      m_is_mipmapped(is_mipmapped) {}

GLenum Texture::target() const {
    switch (m_shape) {
        case PictureShape::cube:
            return GL_TEXTURE_CUBE_MAP;
        case PictureShape::volume:
            return GL_TEXTURE_3D;
        case PictureShape::flat:
            break;
    }
    return GL_TEXTURE_2D;
}

int Texture::levels() const {
    const auto side = static_cast<unsigned>(std::max(m_extent.width, m_extent.height));
    return m_is_mipmapped ? static_cast<int>(std::bit_width(side)) : 1;
}

std::size_t Texture::layers() const {
    constexpr std::size_t faces = 6;
    if (m_shape == PictureShape::flat)
        return 1;
    return m_shape == PictureShape::cube ? faces : static_cast<std::size_t>(m_extent.width);
}

namespace {
bool has_storage() {
    static const bool has = epoxy_has_gl_extension("GL_ARB_texture_storage");
    return has;
}
}  // namespace

// All levels at once if the driver supports it. Level by level, Mesa locks the textures of all
// sharing contexts while it clears the memory.
void Texture::allocate() const {
    if (!has_storage()) {
        for (int level = 0; level < levels(); ++level)
            allocate_level(level, {std::max(1, m_extent.width >> level),
                                   std::max(1, m_extent.height >> level)});
        return;
    }
    const GLenum internal = gl_format(m_format).internal;
    if (m_shape == PictureShape::volume)
        glTexStorage3D(target(), levels(), internal, m_extent.width, m_extent.height,
                       m_extent.width);
    else
        glTexStorage2D(target(), levels(), internal, m_extent.width, m_extent.height);
}

void Texture::allocate_level(int level, const Extent& extent) const {
    const GlFormat gl = gl_format(m_format);
    if (m_shape == PictureShape::volume)
        return glTexImage3D(GL_TEXTURE_3D, level, gl.internal, extent.width, extent.height,
                            extent.width, 0, gl.layout, gl.type, nullptr);
    const GLenum first =
        m_shape == PictureShape::cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : GL_TEXTURE_2D;
    for (std::size_t face = 0; face < layers(); ++face)
        glTexImage2D(first + static_cast<GLenum>(face), level, gl.internal, extent.width,
                     extent.height, 0, gl.layout, gl.type, nullptr);
}

// For reads without a sampler object: a toolkit, or a texelFetch from an integer target.
void Texture::set_own_sampling(int levels) const {
    glTexParameteri(target(), GL_TEXTURE_MAX_LEVEL, levels - 1);
    glTexParameteri(target(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(target(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

Result<Texture> Texture::make(Extent extent, Format format, bool is_mipmapped) {
    assert(!extent.is_empty());
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (std::max(extent.width, extent.height) > largest || !is_possible(extent, gl_format(format)))
        return no_memory(extent, format);
    return allocated(Texture(PictureShape::flat, extent, format, is_mipmapped));
}

Result<Texture> Texture::make_solid(PictureShape shape, int side, Format format,
                                    bool is_mipmapped) {
    assert(side > 0);
    GLint largest = 0;
    glGetIntegerv(
        shape == PictureShape::cube ? GL_MAX_CUBE_MAP_TEXTURE_SIZE : GL_MAX_3D_TEXTURE_SIZE,
        &largest);
    const Extent extent{side, side};
    if (side > largest)
        return no_memory(extent, format);
    return allocated(Texture(shape, extent, format, is_mipmapped));
}

Result<Texture> Texture::allocated(Texture texture) {
    forget_errors();
    glBindTexture(texture.target(), texture.id());
    texture.allocate();
    texture.set_own_sampling(texture.levels());
    glBindTexture(texture.target(), 0);
    if (glGetError() != GL_NO_ERROR)
        return no_memory(texture.m_extent, texture.m_format);
    return texture;
}

void Texture::upload(std::span<const float> texels) {
    assert(!info_of(m_format).is_integer);
    const std::size_t layer =
        static_cast<std::size_t>(m_extent.width) * static_cast<std::size_t>(m_extent.height) * 4;
    assert(texels.size() >= layer * layers());
    glBindTexture(target(), id());
    if (m_shape == PictureShape::volume)
        glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, m_extent.width, m_extent.height, m_extent.width,
                        GL_RGBA, GL_FLOAT, texels.data());
    const bool are_bytes = gl_format(m_format).type == GL_UNSIGNED_BYTE;
    const GLenum first =
        m_shape == PictureShape::cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : GL_TEXTURE_2D;
    for (std::size_t face = 0; m_shape != PictureShape::volume && face < layers(); ++face)
        upload_rows(first + static_cast<GLenum>(face), 0, m_extent, are_bytes,
                    texels.subspan(face * layer));
    glBindTexture(target(), 0);
}

void Texture::generate_mipmaps() const {
    if (!m_is_mipmapped || draw_mip_levels(*this))
        return;
    glBindTexture(target(), id());
    glGenerateMipmap(target());
    glBindTexture(target(), 0);
}

}  // namespace gpu
