#include "gpu/texels.h"

#include "model/encoding_curve.h"

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
}  // namespace

void fill_texels(const Picture& picture, Encoding wanted, std::vector<float>& texels,
                 RowOrder rows) {
    const Extent extent = picture.extent;
    texels.resize(static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height) *
                  4);
    const EncodingCurve* curve = curve_between(picture.encoding, wanted);
    float* texel = texels.data();
    for (int row = 0; row < extent.height; ++row) {
        const int y = rows == RowOrder::top_first ? row : extent.height - 1 - row;
        const float* pixel = picture.pixels.data() + picture.index(0, y);
        if (curve)
            recode_row(pixel, picture.channels, extent.width, *curve, texel);
        else
            fill_row(pixel, picture.channels, extent.width, texel);
        texel += 4 * static_cast<std::size_t>(extent.width);
    }
}

Result<Texture> texture_of(const Picture& picture, Format format, Encoding wanted) {
    auto texture = Texture::make(picture.extent, format);
    if (!texture)
        return texture;
    std::vector<float> texels;
    fill_texels(picture, wanted, texels);
    texture->upload(texels);
    return texture;
}

}  // namespace gpu
