#include "gpu/objects/readback.h"

#include "gpu/objects/canvas.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <span>

namespace gpu {

namespace {
int picture_channels(const FormatInfo& info) {
    return info.channels == 2 ? 3 : info.channels;
}

GLenum layout_of(int channels) {
    return channels == 1 ? GL_RED : channels == 3 ? GL_RGB : GL_RGBA;
}

GLenum integer_layout_of(int channels) {
    return channels == 1 ? GL_RED_INTEGER : channels == 3 ? GL_RGB_INTEGER : GL_RGBA_INTEGER;
}

template <class Whole>
void with_whole_numbers(std::span<float> floats, GLenum type,
                        const std::function<void(GLenum, void*)>& read) {
    std::vector<Whole> whole(floats.size());
    read(type, whole.data());
    std::ranges::transform(whole, floats.begin(),
                           [](Whole number) { return static_cast<float>(number); });
}

// GL returns the texels of integer formats only as integers. `read` gets the component type of the
// format and a buffer for the same number of components.
void with_numbers_of(Format format, std::span<float> floats,
                     const std::function<void(GLenum, void*)>& read) {
    switch (sample_kind_of(format)) {
        case SampleKind::floating:
            return read(GL_FLOAT, floats.data());
        case SampleKind::unsigned_integer:
            return with_whole_numbers<GLuint>(floats, GL_UNSIGNED_INT, read);
        case SampleKind::integer:
            return with_whole_numbers<GLint>(floats, GL_INT, read);
    }
}

void flip_rows(Picture& picture) {
    const auto row = static_cast<std::ptrdiff_t>(picture.extent.width) * picture.channels;
    auto low = picture.pixels.begin();
    auto high = picture.pixels.end() - row;
    for (; low < high; low += row, high -= row)
        std::swap_ranges(low, low + row, high);
}
}  // namespace

Picture read_picture(const Texture& texture) {
    const FormatInfo& info = info_of(texture.format());
    Picture picture{texture.extent(), picture_channels(info), Encoding::linear, {}};
    if (texture.format() == Format::srgb8_alpha8)
        picture.encoding = Encoding::display;
    picture.pixels.resize(picture.index(0, picture.extent.height));
    glFinish();  // as in read_pixel
    glBindTexture(GL_TEXTURE_2D, texture.id());
    const int channels = picture.channels;
    with_numbers_of(texture.format(), picture.pixels, [channels](GLenum type, void* numbers) {
        const GLenum layout = type == GL_FLOAT ? layout_of(channels) : integer_layout_of(channels);
        glGetTexImage(GL_TEXTURE_2D, 0, layout, type, numbers);
    });
    glBindTexture(GL_TEXTURE_2D, 0);
    flip_rows(picture);
    return picture;
}

namespace {
// A copy without conversion, with four channels: with three, a driver converts pixel by pixel.
template <class Numbers>
void copy_texels(const Texture& texture, GLenum type, RawPicture& raw) {
    if (!std::holds_alternative<Numbers>(raw.pixels))
        raw.pixels.emplace<Numbers>();
    auto& numbers = std::get<Numbers>(raw.pixels);
    numbers.resize(raw.row_length() * static_cast<std::size_t>(raw.extent.height));
    glFinish();  // as in read_pixel
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glGetTexImage(GL_TEXTURE_2D, 0, layout_of(raw.channels), type, numbers.data());
    glBindTexture(GL_TEXTURE_2D, 0);
}
}  // namespace

void read_raw(const Texture& texture, RawPicture& raw) {
    raw.extent = texture.extent();
    raw.channels = picture_channels(info_of(texture.format()));
    raw.encoding = Encoding::linear;
    if (texture.format() == Format::rgba8)
        return copy_texels<RawPicture::Bytes>(texture, GL_UNSIGNED_BYTE, raw);
    if (texture.format() == Format::rgba16f)
        return copy_texels<RawPicture::Halves>(texture, GL_HALF_FLOAT, raw);
    Picture picture = read_picture(texture);
    flip_rows(picture);
    raw.encoding = picture.encoding;
    raw.pixels = std::move(picture.pixels);
}

std::array<float, 4> read_pixel(const Texture& texture, int x, int y) {
    const Extent extent = texture.extent();
    assert(x >= 0 && y >= 0 && x < extent.width && y < extent.height);
    glFinish();  // Mesa 22.3's llvmpipe may read before a draw to another framebuffer has finished
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    const Name<delete_framebuffer> framebuffer(id);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, id);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(),
                           0);
    std::array<float, 4> rgba{0.0f, 0.0f, 0.0f, 1.0f};
    const int row = extent.height - 1 - y;
    with_numbers_of(texture.format(), rgba, [x, row](GLenum type, void* numbers) {
        glReadPixels(x, row, 1, 1, type == GL_FLOAT ? GL_RGBA : GL_RGBA_INTEGER, type, numbers);
    });
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    return rgba;
}

}  // namespace gpu
