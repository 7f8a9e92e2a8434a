#include "model/picture/black.h"

#include <algorithm>

namespace {
template <class T>
void blacken(std::vector<T>& numbers, int channels, T opaque) {
    std::ranges::fill(numbers, T{});
    const auto step = static_cast<std::size_t>(channels);
    if (channels == 4)
        for (std::size_t i = step - 1; i < numbers.size(); i += step)
            numbers[i] = opaque;
}
}  // namespace

void blacken(Picture& picture) {
    blacken(picture.pixels, picture.channels, 1.0f);
}

void blacken(RawPicture& raw) {
    constexpr std::uint16_t half_one = 0x3C00;
    constexpr std::uint8_t byte_one = 255;
    if (auto* bytes = std::get_if<RawPicture::Bytes>(&raw.pixels))
        blacken(*bytes, raw.channels, byte_one);
    if (auto* halves = std::get_if<RawPicture::Halves>(&raw.pixels))
        blacken(*halves, raw.channels, half_one);
    if (auto* floats = std::get_if<RawPicture::Floats>(&raw.pixels))
        blacken(*floats, raw.channels, 1.0f);
}
