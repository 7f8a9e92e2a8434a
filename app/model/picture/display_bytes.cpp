#include "model/picture/display_bytes.h"

#include "model/look/color.h"

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
// For all values of 8 or 16 bits.
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

/// Conversion of a colour component, and of alpha.
template <class Byte, class Alpha>
struct ByteOf {
    Byte color;
    Alpha alpha;
};
template <class Byte, class Alpha>
ByteOf(Byte, Alpha) -> ByteOf<Byte, Alpha>;

// Writes `Sent` channels per pixel.
template <int Sent, class Number, class Bytes>
std::uint8_t* put_row(const Number* from, int width, int channels, std::uint8_t* to,
                      const Bytes& byte) {
    constexpr std::uint8_t opaque = 255;
    const std::size_t green = channels < 3 ? 0 : 1;
    for (int x = 0; x < width; ++x, from += channels, to += Sent) {
        to[0] = byte.color(from[0]);
        to[1] = byte.color(from[green]);
        to[2] = byte.color(from[2 * green]);
        if constexpr (Sent == 4)
            to[3] = channels == 4 ? byte.alpha(from[3]) : opaque;
    }
    return to;
}

template <int Sent>
std::vector<std::uint8_t> room_for(Extent extent) {
    return std::vector<std::uint8_t>(static_cast<std::size_t>(extent.width) *
                                     static_cast<std::size_t>(extent.height) * Sent);
}

auto computed_bytes(Encoding encoding) {
    return ByteOf{[encoding](float value) { return display_byte(value, encoding); },
                  [](float value) { return display_byte(value, Encoding::display); }};
}

template <int Sent>
std::vector<std::uint8_t> bytes_of(const Picture& picture) {
    std::vector<std::uint8_t> bytes = room_for<Sent>(picture.extent);
    const auto byte = computed_bytes(picture.encoding);
    std::uint8_t* to = bytes.data();
    for (int y = 0; y < picture.extent.height; ++y)
        to = put_row<Sent>(&picture.pixels[picture.index(0, y)], picture.extent.width,
                           picture.channels, to, byte);
    return bytes;
}

template <int Sent>
std::vector<std::uint8_t> bytes_of(const RawPicture& picture) {
    std::vector<std::uint8_t> bytes = room_for<Sent>(picture.extent);
    const auto put = [&](const auto& numbers, const auto& byte) {
        std::uint8_t* to = bytes.data();
        for (int y = picture.extent.height - 1; y >= 0; --y)
            to = put_row<Sent>(&numbers[static_cast<std::size_t>(y) * picture.row_length()],
                               picture.extent.width, picture.channels, to, byte);
    };
    std::visit(
        [&]<class Number>(const std::vector<Number>& numbers) {
            if constexpr (sizeof(Number) < sizeof(float)) {
                const std::uint8_t* const color = known_bytes<Number>(picture.encoding);
                const std::uint8_t* const alpha = known_bytes<Number>(Encoding::display);
                put(numbers, ByteOf{[color](Number number) { return color[number]; },
                                    [alpha](Number number) { return alpha[number]; }});
            } else {
                put(numbers, computed_bytes(picture.encoding));
            }
        },
        picture.pixels);
    return bytes;
}
}  // namespace

std::vector<std::uint8_t> display_bytes(const Picture& picture) {
    return bytes_of<3>(picture);
}

std::vector<std::uint8_t> display_bytes(const RawPicture& picture) {
    return bytes_of<3>(picture);
}

std::vector<std::uint8_t> display_bytes_with_alpha(const Picture& picture) {
    return bytes_of<4>(picture);
}

std::vector<std::uint8_t> display_bytes_with_alpha(const RawPicture& picture) {
    return bytes_of<4>(picture);
}

bool is_transparent(const Picture& picture) {
    constexpr std::uint8_t opaque = 255;
    if (picture.channels != 4)
        return false;
    for (std::size_t i = 3; i < picture.pixels.size(); i += 4)
        if (display_byte(picture.pixels[i], Encoding::display) != opaque)
            return true;
    return false;
}
