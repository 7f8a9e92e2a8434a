#include "gpu/texture.h"

#include "gpu/gl_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>

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

int level_count(Extent extent, bool is_mipmapped) {
    const auto side = static_cast<unsigned>(std::max(extent.width, extent.height));
    return is_mipmapped ? static_cast<int>(std::bit_width(side)) : 1;
}

// Asks without making an error, which a real allocation past the limit would.
bool is_possible(Extent extent, const GlFormat& format) {
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, format.internal, extent.width, extent.height, 0,
                 format.layout, format.type, nullptr);
    GLint width = 0;
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    return width == extent.width;
}

// Bounded: a lost context reports without end.
void forget_errors() {
    for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
    }
}

tl::unexpected<Diagnostics> no_memory(Extent extent, Format format) {
    return fail({{},
                 0,
                 fmt::format("the graphics driver has no room for a {} x {} px texture in {}",
                             extent.width, extent.height, facts_of(format).name)});
}
}  // namespace

Texture::Texture(Extent extent, Format format, bool is_mipmapped)
    : m_name(new_texture()), m_extent(extent), m_format(format), m_is_mipmapped(is_mipmapped) {}

Result<Texture> Texture::make(Extent extent, Format format, bool is_mipmapped) {
    assert(!extent.is_empty());
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const GlFormat gl = gl_format(format);
    if (std::max(extent.width, extent.height) > largest || !is_possible(extent, gl))
        return no_memory(extent, format);

    Texture texture(extent, format, is_mipmapped);
    const int levels = level_count(extent, is_mipmapped);
    forget_errors();
    glBindTexture(GL_TEXTURE_2D, texture.id());
    for (int level = 0; level < levels; ++level)
        glTexImage2D(GL_TEXTURE_2D, level, gl.internal, std::max(1, extent.width >> level),
                     std::max(1, extent.height >> level), 0, gl.layout, gl.type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
    // For who reads it without a sampler object: a toolkit, or a texelFetch from an integer target.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, 0);
    if (glGetError() != GL_NO_ERROR)
        return no_memory(extent, format);
    return texture;
}

void Texture::upload(std::span<const float> texels) {
    assert(!facts_of(m_format).is_integer);
    assert(texels.size() >= static_cast<std::size_t>(m_extent.width) *
                                static_cast<std::size_t>(m_extent.height) * 4);
    glBindTexture(GL_TEXTURE_2D, id());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, m_extent.width, m_extent.height, GL_RGBA, GL_FLOAT,
                    texels.data());
    glBindTexture(GL_TEXTURE_2D, 0);
}

void Texture::generate_mipmaps() {
    if (!m_is_mipmapped)
        return;
    glBindTexture(GL_TEXTURE_2D, id());
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace gpu
