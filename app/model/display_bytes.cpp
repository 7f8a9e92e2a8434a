#include "model/display_bytes.h"

#include "model/color.h"

#include <algorithm>
#include <cmath>

std::uint8_t display_byte(float value, Encoding encoding) {
    if (!(value > 0.0f))  // NaN too
        return 0;
    double display = std::min(static_cast<double>(value), 1.0);
    if (encoding == Encoding::linear)
        display = srgb_encode(display);
    return static_cast<std::uint8_t>(std::lround(display * 255.0));
}

namespace {
// Of every number that there is of 8 or 16 bits.
template <class Number>
struct KnownBytes {
    explicit KnownBytes(Encoding encoding) : bytes(std::size_t{1} << (8 * sizeof(Number))) {
        for (std::size_t bits = 0; bits < bytes.size(); ++bits)
            bytes[bits] = display_byte(number_of(static_cast<Number>(bits)), encoding);
    }
    std::vector<std::uint8_t> bytes;
};

template <class Number>
const std::uint8_t* known_bytes(Encoding encoding) {
    static const KnownBytes<Number> linear(Encoding::linear);
    static const KnownBytes<Number> display(Encoding::display);
    return (encoding == Encoding::linear ? linear : display).bytes.data();
}

template <class Number, class Byte>
std::uint8_t* put_row(const Number* from, int width, int channels, std::uint8_t* to, Byte byte) {
    const std::size_t green = channels < 3 ? 0 : 1;
    for (int x = 0; x < width; ++x, from += channels, to += 3) {
        to[0] = byte(from[0]);
        to[1] = byte(from[green]);
        to[2] = byte(from[2 * green]);
    }
    return to;
}

std::vector<std::uint8_t> room_for(Extent extent) {
    return std::vector<std::uint8_t>(static_cast<std::size_t>(extent.width) *
                                     static_cast<std::size_t>(extent.height) * 3);
}
}  // namespace

std::vector<std::uint8_t> display_bytes(const Picture& picture) {
    std::vector<std::uint8_t> bytes = room_for(picture.extent);
    std::uint8_t* to = bytes.data();
    for (int y = 0; y < picture.extent.height; ++y)
        to = put_row(&picture.pixels[picture.index(0, y)], picture.extent.width, picture.channels,
                     to, [&](float value) { return display_byte(value, picture.encoding); });
    return bytes;
}

std::vector<std::uint8_t> display_bytes(const RawPicture& picture) {
    std::vector<std::uint8_t> bytes = room_for(picture.extent);
    const auto put = [&](const auto& numbers, const auto& byte) {
        std::uint8_t* to = bytes.data();
        for (int y = picture.extent.height - 1; y >= 0; --y)
            to = put_row(&numbers[static_cast<std::size_t>(y) * picture.row_length()],
                         picture.extent.width, picture.channels, to, byte);
    };
    std::visit(
        [&]<class Number>(const std::vector<Number>& numbers) {
            if constexpr (sizeof(Number) < sizeof(float)) {
                const std::uint8_t* const known = known_bytes<Number>(picture.encoding);
                put(numbers, [known](Number number) { return known[number]; });
            } else {
                put(numbers, [&](float value) { return display_byte(value, picture.encoding); });
            }
        },
        picture.pixels);
    return bytes;
}
