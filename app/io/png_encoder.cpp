#include "io/png_encoder.h"

#include "model/color.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <png.h>

namespace {
std::uint8_t display_byte(float value, Encoding encoding) {
    if (!(value > 0.0f))  // NaN too
        return 0;
    double display = std::min(static_cast<double>(value), 1.0);
    if (encoding == Encoding::linear)
        display = srgb_encode(display);
    return static_cast<std::uint8_t>(std::lround(display * 255.0));
}

std::vector<std::uint8_t> display_bytes(const Picture& picture) {
    std::vector<std::uint8_t> bytes;
    const auto channels = static_cast<std::size_t>(picture.channels);
    bytes.reserve(picture.pixels.size() / channels * 3);
    for (std::size_t i = 0; i < picture.pixels.size(); i += channels)
        for (std::size_t channel = 0; channel < 3; ++channel)
            bytes.push_back(
                display_byte(picture.pixels[i + (channels < 3 ? 0 : channel)], picture.encoding));
    return bytes;
}
}  // namespace

Result<std::string> encode_png(const Picture& picture) {
    assert(picture.pixels.size() == picture.index(0, picture.extent.height));
    const std::vector<std::uint8_t> pixels = display_bytes(picture);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.extent.width);
    image.height = static_cast<png_uint_32>(picture.extent.height);
    image.format = PNG_FORMAT_RGB;
    image.flags = PNG_IMAGE_FLAG_FAST;  // 0.6 of the time for 1.2 of the bytes
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr))
        return fail({{}, 0, std::string("cannot be encoded: ") + image.message});
    bytes.resize(size);
    bytes.shrink_to_fit();
    return bytes;
}
