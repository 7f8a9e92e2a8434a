#include "formats/mpv_export/mpv_picture.h"

#include "io/pictures/picture_file.h"
#include "model/picture/encoding_curve.h"
#include "signals/patterns/generated_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace {
constexpr std::size_t max_texels = std::size_t{1} << 22;
constexpr float largest_byte = 255.0f;

std::uint8_t byte_of(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * largest_byte));
}

// RGBA, the first row that of v = 0.
std::vector<float> texels_of(const Picture& picture, RowOrder rows) {
    std::vector<float> texels;
    texels.reserve(4 * static_cast<std::size_t>(picture.extent.width) *
                   static_cast<std::size_t>(picture.extent.height));
    for (int row = 0; row < picture.extent.height; ++row) {
        const int y = rows == RowOrder::top_first ? row : picture.extent.height - 1 - row;
        for (int x = 0; x < picture.extent.width; ++x) {
            const float* const pixel = picture.pixels.data() + picture.index(x, y);
            const bool is_grey = picture.channels == 1;
            texels.insert(texels.end(), {pixel[0], pixel[is_grey ? 0 : 1], pixel[is_grey ? 0 : 2],
                                         picture.channels == 4 ? pixel[3] : 1.0f});
        }
    }
    return texels;
}

// As a graphics card decodes them.
void decode(std::vector<float>& texels) {
    const EncodingCurve& curve = *curve_between(Encoding::display, Encoding::linear);
    for (std::size_t i = 0; i < texels.size(); ++i)
        if (i % 4 != 3)
            texels[i] = curve(static_cast<float>(byte_of(texels[i])) / largest_byte);
}

void append_byte(std::string& text, std::uint8_t byte) {
    constexpr std::string_view digits = "0123456789abcdef";
    text += digits[byte >> 4];
    text += digits[byte & 15];
}

std::string hexadecimal(const std::vector<float>& texels, bool are_bytes) {
    std::string text;
    text.reserve(texels.size() * (are_bytes ? 2 : 8));
    for (const float value : texels) {
        if (are_bytes) {
            append_byte(text, byte_of(value));
            continue;
        }
        const auto bits = std::bit_cast<std::uint32_t>(value);
        for (int shift = 0; shift < 32; shift += 8)  // the lowest byte first
            append_byte(text, static_cast<std::uint8_t>(bits >> shift));
    }
    return text;
}

Picture black_picture() {
    return {.extent = {1, 1},
            .channels = 4,
            .encoding = Encoding::display,
            .pixels = {0.0f, 0.0f, 0.0f, 0.0f}};
}
}  // namespace

Result<MpvPicture> mpv_picture(const Look& look, const Image& image) {
    auto picture = image.made.empty() ? load_picture(image.file) : made_picture(image.made);
    if (!picture && image.is_needed)
        return fail(picture.error());
    if (!picture)
        picture = black_picture();
    const Extent extent = picture->extent;
    if (static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height) >
        max_texels)
        return fail({image.file, 0,
                     "The picture has more than 4 million texels, which makes the file too large "
                     "for mpv. Use a smaller picture."});
    if (!image.is_linear)
        recode(*picture, image.encoding.value_or(look.source_encoding));
    std::vector<float> texels = texels_of(*picture, image.rows);
    if (image.format == Format::srgb8_alpha8)
        decode(texels);
    const bool are_bytes =
        image.format == Format::rgba8 || std::ranges::all_of(texels, [](float value) {
            return value == static_cast<float>(byte_of(value)) / largest_byte;
        });
    return MpvPicture{
        extent, fmt::format("//!SIZE {} {}\n//!FORMAT {}\n//!FILTER LINEAR\n{}\n", extent.width,
                            extent.height, are_bytes ? "rgba8" : "rgba32f",
                            hexadecimal(texels, are_bytes))};
}
