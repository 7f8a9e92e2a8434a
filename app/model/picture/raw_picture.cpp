#include "model/picture/raw_picture.h"

#include <glm/gtc/packing.hpp>

#include <algorithm>

// A multiplication, as in drivers: gives the same value as reading floats from GL.
float number_of(std::uint8_t byte) {
    return static_cast<float>(byte) * (1.0f / 255.0f);
}

float number_of(std::uint16_t half) {
    return glm::unpackHalf1x16(half);
}

Picture picture_of(const RawPicture& raw) {
    Picture picture{raw.extent, raw.channels, raw.encoding, {}};
    picture.pixels.resize(picture.index(0, raw.extent.height));
    const auto length = static_cast<std::ptrdiff_t>(raw.row_length());
    std::visit(
        [&](const auto& numbers) {
            auto to = picture.pixels.begin();
            for (auto row = numbers.end(); row != numbers.begin();) {
                row -= length;
                to = std::transform(row, row + length, to,
                                    [](auto number) { return number_of(number); });
            }
        },
        raw.pixels);
    return picture;
}

RawPicture raw_of(const Picture& picture) {
    RawPicture raw{picture.extent, picture.channels, picture.encoding, RawPicture::Floats()};
    auto& pixels = std::get<RawPicture::Floats>(raw.pixels);
    pixels.reserve(picture.pixels.size());
    for (int y = picture.extent.height - 1; y >= 0; --y) {
        const auto row = picture.pixels.begin() + static_cast<std::ptrdiff_t>(picture.index(0, y));
        pixels.insert(pixels.end(), row, row + static_cast<std::ptrdiff_t>(raw.row_length()));
    }
    return raw;
}
