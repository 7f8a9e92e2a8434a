#include "model/picture/byte_pixels.h"

#include <array>

float float_of(std::uint8_t byte) {
    static const auto values = [] {
        std::array<float, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i)
            table[i] = static_cast<float>(i) / 255.0f;
        return table;
    }();
    return values[byte];
}

Picture with_floats(const Picture& picture) {
    if (!picture.bytes)
        return picture;
    Picture made{picture.extent, 3, picture.encoding, {}};
    const std::size_t count = picture.index(0, picture.extent.height) / 4;
    made.pixels.resize(count * 3);
    const std::uint8_t* pixel = picture.bytes.get();
    for (std::size_t i = 0; i < count; ++i, pixel += 4)
        for (std::size_t c = 0; c < 3; ++c)
            made.pixels[3 * i + c] = float_of(pixel[2 - c]);
    return made;
}
