#include "gpu/readback.h"

#include "gpu/canvas.h"

#include <algorithm>
#include <cassert>

namespace gpu {

namespace {
int picture_channels(const FormatFacts& facts) {
    return facts.channels == 2 ? 3 : facts.channels;
}

GLenum layout_of(int channels) {
    return channels == 1 ? GL_RED : channels == 3 ? GL_RGB : GL_RGBA;
}

GLenum integer_layout_of(int channels) {
    return channels == 1 ? GL_RED_INTEGER : channels == 3 ? GL_RGB_INTEGER : GL_RGBA_INTEGER;
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
    const FormatFacts& facts = facts_of(texture.format());
    Picture picture{texture.extent(), picture_channels(facts), Encoding::linear, {}};
    if (texture.format() == Format::srgb8_alpha8)
        picture.encoding = Encoding::display;
    picture.pixels.resize(picture.index(0, picture.extent.height));
    glFinish();  // as in read_pixel
    glBindTexture(GL_TEXTURE_2D, texture.id());
    if (facts.is_integer) {
        std::vector<GLuint> whole(picture.pixels.size());
        glGetTexImage(GL_TEXTURE_2D, 0, integer_layout_of(picture.channels), GL_UNSIGNED_INT,
                      whole.data());
        std::ranges::transform(whole, picture.pixels.begin(),
                               [](GLuint number) { return static_cast<float>(number); });
    } else {
        glGetTexImage(GL_TEXTURE_2D, 0, layout_of(picture.channels), GL_FLOAT,
                      picture.pixels.data());
    }
    glBindTexture(GL_TEXTURE_2D, 0);
    flip_rows(picture);
    return picture;
}

namespace {
// As it is, four channels at a time: with three, a driver goes pixel by pixel.
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
    raw.channels = picture_channels(facts_of(texture.format()));
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
    glFinish();  // Mesa 22.3's llvmpipe reads what another framebuffer has not drawn to its end yet
    GLuint id = 0;
    glGenFramebuffers(1, &id);
    const Name<delete_framebuffer> framebuffer(id);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, id);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(),
                           0);
    std::array<float, 4> rgba{0.0f, 0.0f, 0.0f, 1.0f};
    const int row = extent.height - 1 - y;
    if (facts_of(texture.format()).is_integer) {
        std::array<GLuint, 4> whole{};
        glReadPixels(x, row, 1, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT, whole.data());
        std::ranges::transform(whole, rgba.begin(),
                               [](GLuint number) { return static_cast<float>(number); });
    } else {
        glReadPixels(x, row, 1, 1, GL_RGBA, GL_FLOAT, rgba.data());
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    return rgba;
}

}  // namespace gpu
