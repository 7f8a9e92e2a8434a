#pragma once

#include "portable_player/gl.h"
#include "portable_player/pictures.h"

#include <map>
#include <string>
#include <vector>

enum class Numbers { floating, integer, natural };

/// A pixel format of docs/look-format.md. Fails for an unknown one.
struct Format {
    GLenum internal;
    Numbers numbers;
};
Format format_named(const std::string& name);

/// The format with red only, or with 16-bit floats; the same if there is none.
std::string one_channel_of(const std::string& format);
std::string half_floats_of(const std::string& format);

enum class Shape { flat, cube, volume };

/// A texture with room for all its levels. A cube or volume has square faces.
class Texture {
public:
    Texture(Shape shape, const Size& size, const std::string& format, bool is_mipmapped);

    /// Writes the pixels of a picture of the same shape.
    void upload(const Picture& picture, bool is_top_first) const;
    void generate_mipmaps() const;

    GLenum target() const;
    GLuint name() const { return m_name.get(); }
    const Size& size() const { return m_size; }
    Shape shape() const { return m_shape; }
    const std::string& format() const { return m_format; }
    Numbers numbers() const { return format_named(m_format).numbers; }
    bool is_mipmapped() const { return m_is_mipmapped; }

private:
    void allocate(int level, int width, int height) const;

    GlName<delete_texture> m_name;
    Shape m_shape;
    Size m_size;
    std::string m_format;
    bool m_is_mipmapped;
};

/// A texture to draw into. At first it is transparent black.
class Canvas {
public:
    Canvas(const Size& size, const std::string& format, bool is_mipmapped);

    void bind() const;
    void clear(float number) const;
    void copy_to(const Canvas& other) const;
    /// RGBA floats, first the row at v = 0.
    std::vector<float> read() const;
    /// Copies six faces next to each other.
    void copy_faces_to(const Texture& cube) const;

    const Texture& texture() const { return m_texture; }

private:
    Texture m_texture;
    GlName<delete_framebuffer> m_name;
};

/// Binds textures to units, with sampler objects for each combination of settings.
class Samplers {
public:
    void bind(int unit, const Texture& texture, const Sampler& sampler);

private:
    GLuint object_for(const Sampler& sampler);

    std::map<std::string, GlName<delete_sampler>> m_made;
};
