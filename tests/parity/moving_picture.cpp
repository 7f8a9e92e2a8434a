#include "parity/moving_picture.h"

namespace plain {

namespace {
std::uint32_t noise(std::uint32_t x, std::uint32_t y, std::uint32_t frame) {
    std::uint32_t n = x * 374761393u + y * 668265263u + frame * 2246822519u;
    n = (n ^ (n >> 13u)) * 1274126177u;
    return n ^ (n >> 16u);
}

std::array<std::uint32_t, 3> color_at(std::uint32_t x, std::uint32_t y, Extent extent, int frame) {
    const auto width = static_cast<std::uint32_t>(extent.width);
    const auto height = static_cast<std::uint32_t>(extent.height);
    const auto step = static_cast<std::uint32_t>(frame);
    const std::uint32_t moved = x + 3 * step;
    switch (4 * y / height) {
        case 0:  // gradients
            return {255 * moved / width % 256, 255 - 255 * x / width, 1020 * y / height};
        case 1:  // tiles
            return (moved / 8 + y / 8) % 2 == 0 ? std::array{224u, 80u, 32u}
                                                : std::array{16u, 48u, 160u};
        case 2:  // lines and single pixels
            return (moved + y) % 13 == 0 || (moved % 16 == 0 && y % 4 == 0)
                       ? std::array{255u, 255u, 255u}
                       : std::array{0u, 24u, 8u};
        default:
            break;
    }
    const std::uint32_t n = noise(x, y, step);
    return {n & 255u, (n >> 8u) & 255u, (n >> 16u) & 255u};
}
}  // namespace

Bytes moving_picture(Extent extent, int frame) {
    constexpr std::uint8_t opaque = 255;
    Bytes picture{extent, {}};
    for (int y = 0; y < extent.height; ++y)
        for (int x = 0; x < extent.width; ++x) {
            for (const std::uint32_t part : color_at(static_cast<std::uint32_t>(x),
                                                     static_cast<std::uint32_t>(y), extent, frame))
                picture.rgba.push_back(static_cast<std::uint8_t>(part));
            picture.rgba.push_back(opaque);
        }
    return picture;
}

Picture picture_of(const Bytes& bytes) {
    Picture picture{bytes.extent, 4, Encoding::display, {}};
    for (const std::uint8_t byte : bytes.rgba)
        picture.pixels.push_back(static_cast<float>(byte) / 255.0f);
    return picture;
}

}  // namespace plain
