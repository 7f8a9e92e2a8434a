#include "portable_player/textures.h"

#include "portable_player/error.h"

#include <algorithm>
#include <bit>

namespace {
// clang-format off
const std::map<std::string, GLenum> internal_formats{
    {"r8", GL_R8}, {"rg8", GL_RG8}, {"rgba8", GL_RGBA8}, {"srgb8_alpha8", GL_SRGB8_ALPHA8},
    {"rgb10_a2", GL_RGB10_A2}, {"r16f", GL_R16F}, {"rg16f", GL_RG16F}, {"rgba16f", GL_RGBA16F},
    {"r32f", GL_R32F}, {"rg32f", GL_RG32F}, {"rgba32f", GL_RGBA32F},
    {"r11f_g11f_b10f", GL_R11F_G11F_B10F}, {"r8ui", GL_R8UI}, {"rg8ui", GL_RG8UI},
    {"rgba8ui", GL_RGBA8UI}, {"r16ui", GL_R16UI}, {"rg16ui", GL_RG16UI},
    {"rgba16ui", GL_RGBA16UI}, {"r32ui", GL_R32UI}, {"rg32ui", GL_RG32UI},
    {"rgba32ui", GL_RGBA32UI}, {"rgb10_a2ui", GL_RGB10_A2UI}, {"r8i", GL_R8I}, {"rg8i", GL_RG8I},
    {"rgba8i", GL_RGBA8I}, {"r16i", GL_R16I}, {"rg16i", GL_RG16I}, {"rgba16i", GL_RGBA16I},
    {"r32i", GL_R32I}, {"rg32i", GL_RG32I}, {"rgba32i", GL_RGBA32I}};
// clang-format on

GLuint new_texture() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return name;
}

GLuint new_framebuffer() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return name;
}

constexpr GLenum faces_from = GL_TEXTURE_CUBE_MAP_POSITIVE_X;
constexpr GLenum face_count = 6;
}  // namespace

Format format_named(const std::string& name) {
    const auto found = internal_formats.find(name);
    if (found == internal_formats.end())
        throw Error("has the unknown pixel format '" + name + "'");
    const Numbers numbers = name.ends_with("ui")  ? Numbers::natural
                            : name.ends_with('i') ? Numbers::integer
                                                  : Numbers::floating;
    return {found->second, numbers};
}

std::string one_channel_of(const std::string& format) {
    for (const char* const depth : {"8", "16f", "32f"})
        if (format == std::string("rg") + depth || format == std::string("rgba") + depth)
            return std::string("r") + depth;
    return format;
}

std::string half_floats_of(const std::string& format) {
    for (const char* const channels : {"r", "rg", "rgba"})
        if (format == std::string(channels) + "32f")
            return std::string(channels) + "16f";
    return format;
}

Texture::Texture(Shape shape, const Size& size, const std::string& format, bool is_mipmapped)
    : m_name(new_texture()),
      m_shape(shape),
      m_size(size),
      m_format(format),
      m_is_mipmapped(is_mipmapped && format_named(format).numbers == Numbers::floating) {
    const auto longest = static_cast<unsigned>(std::max(size[0], size[1]));
    const int levels = m_is_mipmapped ? static_cast<int>(std::bit_width(longest)) : 1;
    glBindTexture(target(), name());
    for (int level = 0; level < levels; ++level)
        allocate(level, std::max(size[0] >> level, 1), std::max(size[1] >> level, 1));
    glTexParameteri(target(), GL_TEXTURE_MAX_LEVEL, levels - 1);
    if (glGetError() != GL_NO_ERROR)
        throw Error("the graphics driver can't create a texture of the format " + format);
}

GLenum Texture::target() const {
    return m_shape == Shape::flat   ? GL_TEXTURE_2D
           : m_shape == Shape::cube ? GL_TEXTURE_CUBE_MAP
                                    : GL_TEXTURE_3D;
}

void Texture::allocate(int level, int width, int height) const {
    const auto internal = static_cast<GLint>(format_named(m_format).internal);
    const bool is_floating = numbers() == Numbers::floating;
    const GLenum layout = is_floating ? GL_RGBA : GL_RGBA_INTEGER;
    const GLenum type = is_floating                     ? GL_FLOAT
                        : numbers() == Numbers::integer ? GL_INT
                                                        : GL_UNSIGNED_INT;
    if (m_shape == Shape::volume)
        return glTexImage3D(GL_TEXTURE_3D, level, internal, width, height, width, 0, layout, type,
                            nullptr);
    for (GLenum face = 0; face < (m_shape == Shape::cube ? face_count : 1); ++face)
        glTexImage2D(m_shape == Shape::cube ? faces_from + face : GL_TEXTURE_2D, level, internal,
                     width, height, 0, layout, type, nullptr);
}

// Pictures begin with the top row, textures with the row at v = 0. Faces and slices are not
// flipped one by one: the whole column of them is.
void Texture::upload(const Picture& picture, bool is_top_first) const {
    const auto row = 4 * static_cast<std::size_t>(picture.width);
    std::vector<float> texels = picture.pixels;
    for (std::size_t y = 0; !is_top_first && y < static_cast<std::size_t>(picture.height); ++y)
        std::copy_n(picture.pixels.end() - static_cast<std::ptrdiff_t>((y + 1) * row), row,
                    texels.begin() + static_cast<std::ptrdiff_t>(y * row));
    const auto internal = static_cast<GLint>(format_named(m_format).internal);
    glBindTexture(target(), name());
    if (m_shape == Shape::volume)
        return glTexImage3D(GL_TEXTURE_3D, 0, internal, m_size[0], m_size[1], m_size[0], 0, GL_RGBA,
                            GL_FLOAT, texels.data());
    for (GLenum face = 0; face < (m_shape == Shape::cube ? face_count : 1); ++face)
        glTexImage2D(m_shape == Shape::cube ? faces_from + face : GL_TEXTURE_2D, 0, internal,
                     m_size[0], m_size[1], 0, GL_RGBA, GL_FLOAT,
                     texels.data() + face * row * static_cast<std::size_t>(m_size[1]));
}

void Texture::generate_mipmaps() const {
    if (!m_is_mipmapped)
        return;
    glBindTexture(target(), name());
    glGenerateMipmap(target());
}

Canvas::Canvas(const Size& size, const std::string& format, bool is_mipmapped)
    : m_texture(Shape::flat, size, format, is_mipmapped), m_name(new_framebuffer()) {
    glBindFramebuffer(GL_FRAMEBUFFER, m_name.get());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_texture.name(),
                           0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error("the graphics driver can't draw into the format " + format);
    clear(0.0F);
    m_texture.generate_mipmaps();
}

void Canvas::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, m_name.get());
    glViewport(0, 0, m_texture.size()[0], m_texture.size()[1]);
}

void Canvas::clear(float number) const {
    bind();
    const auto whole = static_cast<GLint>(number);
    const auto natural = static_cast<GLuint>(number);
    const std::array<GLfloat, 4> floats{number, number, number, number};
    const std::array<GLint, 4> integers{whole, whole, whole, whole};
    const std::array<GLuint, 4> naturals{natural, natural, natural, natural};
    switch (m_texture.numbers()) {
        case Numbers::floating:
            return glClearBufferfv(GL_COLOR, 0, floats.data());
        case Numbers::integer:
            return glClearBufferiv(GL_COLOR, 0, integers.data());
        case Numbers::natural:
            return glClearBufferuiv(GL_COLOR, 0, naturals.data());
    }
}

void Canvas::copy_to(const Canvas& other) const {
    const Size& size = m_texture.size();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_name.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, other.m_name.get());
    glBlitFramebuffer(0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
}

std::vector<float> Canvas::read() const {
    const Size& size = m_texture.size();
    std::vector<float> texels(4 * static_cast<std::size_t>(size[0]) *
                              static_cast<std::size_t>(size[1]));
    bind();
    glReadPixels(0, 0, size[0], size[1], GL_RGBA, GL_FLOAT, texels.data());
    return texels;
}

void Canvas::copy_faces_to(const Texture& cube) const {
    const int side = cube.size()[0];
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_name.get());
    glBindTexture(GL_TEXTURE_CUBE_MAP, cube.name());
    for (int face = 0; face < static_cast<int>(face_count); ++face)
        glCopyTexSubImage2D(faces_from + static_cast<GLenum>(face), 0, 0, 0, face * side, 0, side,
                            side);
}

void Samplers::bind(int unit, const Texture& texture, const Sampler& sampler) {
    Sampler usable = sampler;
    if (texture.numbers() != Numbers::floating)
        usable.is_linear = usable.is_mipmapped = false;
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(texture.target(), texture.name());
    glBindSampler(static_cast<GLuint>(unit), object_for(usable));
}

GLuint Samplers::object_for(const Sampler& sampler) {
    const std::string key = sampler.wrap + (sampler.is_linear ? " linear" : "") +
                            (sampler.is_mipmapped ? " mipmap" : "") +
                            (sampler.blends_levels ? " blends" : "");
    if (const auto found = m_made.find(key); found != m_made.end())
        return found->second.get();
    GLuint name = 0;
    glGenSamplers(1, &name);
    m_made.emplace(key, GlName<delete_sampler>(name));
    const GLint single = sampler.is_linear ? GL_LINEAR : GL_NEAREST;
    const GLint nearest_levels =
        sampler.is_linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
    const GLint blended_levels =
        sampler.is_linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
    const GLint wrap = sampler.wrap == "border"   ? GL_CLAMP_TO_BORDER
                       : sampler.wrap == "repeat" ? GL_REPEAT
                       : sampler.wrap == "mirror" ? GL_MIRRORED_REPEAT
                                                  : GL_CLAMP_TO_EDGE;
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, single);
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER,
                        !sampler.is_mipmapped   ? single
                        : sampler.blends_levels ? blended_levels
                                                : nearest_levels);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glSamplerParameteri(name, axis, wrap);
    return name;
}
