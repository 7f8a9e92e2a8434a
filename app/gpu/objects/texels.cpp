#include "gpu/objects/texels.h"

#include "gpu/objects/gl_format.h"
#include "gpu/objects/upload_rows.h"
#include "model/picture/byte_pixels.h"
#include "model/picture/encoding_curve.h"

#include <algorithm>
#include <array>

namespace gpu {

namespace {
std::array<float, 4> rgba_of(const float* pixel, int channels) {
    if (channels == 1)
        return {pixel[0], pixel[0], pixel[0], 1.0f};
    return {pixel[0], pixel[1], pixel[2], channels == 4 ? pixel[3] : 1.0f};
}

void fill_row(const float* pixel, int channels, int width, float* texel) {
    if (channels == 4) {
        std::copy_n(pixel, 4 * static_cast<std::size_t>(width), texel);
        return;
    }
    for (int x = 0; x < width; ++x, pixel += channels, texel += 4) {
        const std::array<float, 4> rgba = rgba_of(pixel, channels);
        std::ranges::copy(rgba, texel);
    }
}

void recode_row(const float* pixel, int channels, int width, const EncodingCurve& curve,
                float* texel) {
    for (int x = 0; x < width; ++x, pixel += channels, texel += 4) {
        const std::array<float, 4> rgba = rgba_of(pixel, channels);
        for (std::size_t c = 0; c < 3; ++c)
            texel[c] = curve(rgba[c]);
        texel[3] = rgba[3];
    }
}

// The colours of bytes: a table, because there are only 256.
using ByteCurve = std::array<float, 256>;

ByteCurve curve_of_bytes(const EncodingCurve* curve) {
    ByteCurve table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float number = float_of(static_cast<std::uint8_t>(i));
        table[i] = curve ? (*curve)(number) : number;
    }
    return table;
}

// `count` rows of the texture, starting at `first`.
void fill_byte_rows(const Picture& picture, const ByteCurve& curve, RowOrder rows, int first,
                    int count, float* texel) {
    const Extent extent = picture.extent;
    for (int row = first; row < first + count; ++row) {
        const int y = rows == RowOrder::top_first ? row : extent.height - 1 - row;
        const std::uint8_t* byte = bytes_at(picture, 0, y);
        for (int x = 0; x < extent.width; ++x, byte += 4, texel += 4) {
            texel[0] = curve[byte[2]];
            texel[1] = curve[byte[1]];
            texel[2] = curve[byte[0]];
            texel[3] = 1.0f;
        }
    }
}

// `count` rows of the texture, starting at `first`.
void fill_rows(const Picture& picture, const EncodingCurve* curve, RowOrder rows, int first,
               int count, float* texel) {
    const Extent extent = picture.extent;
    if (picture.bytes)
        return fill_byte_rows(picture, curve_of_bytes(curve), rows, first, count, texel);
    for (int row = first; row < first + count; ++row) {
        const int y = rows == RowOrder::top_first ? row : extent.height - 1 - row;
        const float* pixel = picture.pixels.data() + picture.index(0, y);
        if (curve)
            recode_row(pixel, picture.channels, extent.width, *curve, texel);
        else
            fill_row(pixel, picture.channels, extent.width, texel);
        texel += 4 * static_cast<std::size_t>(extent.width);
    }
}
}  // namespace

void fill_texels(const Picture& picture, Encoding wanted, std::vector<float>& texels,
                 RowOrder rows) {
    const Extent extent = picture.extent;
    texels.resize(static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height) *
                  4);
    fill_rows(picture, curve_between(picture.encoding, wanted), rows, 0, extent.height,
              texels.data());
}

void upload_picture(Texture& texture, const Picture& picture, Encoding wanted,
                    std::vector<float>& band, RowOrder rows) {
    constexpr int texels_at_once = 1 << 20;
    const Extent extent = picture.extent;
    const EncodingCurve* curve = curve_between(picture.encoding, wanted);
    const int max_rows = std::clamp(texels_at_once / extent.width, 1, extent.height);
    const auto row_length = static_cast<std::size_t>(extent.width) * 4;
    band.resize(row_length * static_cast<std::size_t>(max_rows));
    const bool are_bytes = gl_format(texture.format()).type == GL_UNSIGNED_BYTE;
    for (int row = 0; row < extent.height; row += max_rows) {
        const int count = std::min(max_rows, extent.height - row);
        fill_rows(picture, curve, rows, row, count, band.data());
        glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(texture.handle()));
        upload_rows(GL_TEXTURE_2D, row, {extent.width, count}, are_bytes,
                    {band.data(), row_length * static_cast<std::size_t>(count)});
    }
    glBindTexture(GL_TEXTURE_2D, 0);
}

Result<Texture> texture_of(const Picture& picture, Format format, Encoding wanted) {
    auto texture = Texture::make(picture.extent, format);
    if (!texture)
        return texture;
    std::vector<float> band;
    upload_picture(*texture, picture, wanted, band);
    return texture;
}

}  // namespace gpu
