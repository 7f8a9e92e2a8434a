#include "io/video/frame_bytes.h"

#include "model/look/color.h"
#include "model/picture/display_bytes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {
constexpr double largest = 65535.0;

std::uint16_t display_word(float value, Encoding encoding) {
    if (!(value > 0.0f))  // NaN too
        return 0;
    double display = std::min(static_cast<double>(value), 1.0);
    if (encoding == Encoding::linear)
        display = srgb_encode(display);
    return static_cast<std::uint16_t>(std::lround(display * largest));
}

/// For all values of 8 or 16 bits.
template <class Number>
class KnownWords {
public:
    explicit KnownWords(Encoding encoding) : m_words(std::size_t{1} << (8 * sizeof(Number))) {
        for (std::size_t bits = 0; bits < m_words.size(); ++bits)
            m_words[bits] = display_word(number_of(static_cast<Number>(bits)), encoding);
    }
    std::uint16_t operator()(Number number) const { return m_words[number]; }

private:
    std::vector<std::uint16_t> m_words;
};

template <class Number>
const KnownWords<Number>& known_words(Encoding encoding) {
    static const KnownWords<Number> linear(Encoding::linear);
    static const KnownWords<Number> display(Encoding::display);
    return encoding == Encoding::linear ? linear : display;
}

using Pixel = std::array<std::uint16_t, 4>;

Pixel with_alpha_from_black(Pixel pixel) {
    const std::uint16_t alpha = std::max({pixel[0], pixel[1], pixel[2]});
    for (std::size_t channel = 0; alpha > 0 && channel < 3; ++channel)
        pixel[channel] = static_cast<std::uint16_t>(std::lround(largest * pixel[channel] / alpha));
    pixel[3] = alpha;
    return pixel;
}

template <class Number, class Color, class Alpha>
void put_rows(const RawPicture& picture, const std::vector<Number>& numbers, FrameAlpha alpha,
              const Color& color_word, const Alpha& alpha_word, std::vector<std::uint16_t>& words) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    const std::size_t green = channels < 3 ? 0 : 1;
    std::uint16_t* to = words.data();
    for (int y = picture.extent.height - 1; y >= 0; --y) {
        const Number* from = &numbers[static_cast<std::size_t>(y) * picture.row_length()];
        for (int x = 0; x < picture.extent.width; ++x, from += channels, to += 4) {
            Pixel pixel{color_word(from[0]), color_word(from[green]), color_word(from[2 * green]),
                        static_cast<std::uint16_t>(largest)};
            if (alpha == FrameAlpha::own && channels == 4)
                pixel[3] = alpha_word(from[3]);
            if (alpha == FrameAlpha::from_black)
                pixel = with_alpha_from_black(pixel);
            std::ranges::copy(pixel, to);
        }
    }
}

// The nearest of 0..255.
char byte_of(std::uint16_t word) {
    return static_cast<char>(static_cast<std::uint8_t>((word * 255u + 32767u) / 65535u));
}
}  // namespace

std::vector<std::uint16_t> display_words(const RawPicture& picture, FrameAlpha alpha) {
    std::vector<std::uint16_t> words(static_cast<std::size_t>(picture.extent.width) *
                                     static_cast<std::size_t>(picture.extent.height) * 4);
    std::visit(
        [&]<class Number>(const std::vector<Number>& numbers) {
            if constexpr (sizeof(Number) < sizeof(float))
                put_rows(picture, numbers, alpha, known_words<Number>(picture.encoding),
                         known_words<Number>(Encoding::display), words);
            else
                put_rows(
                    picture, numbers, alpha,
                    [&](float value) { return display_word(value, picture.encoding); },
                    [](float value) { return display_word(value, Encoding::display); }, words);
        },
        picture.pixels);
    return words;
}

std::string frame_bytes(const RawPicture& picture, int bits, FrameAlpha alpha) {
    if (bits == 8 && alpha != FrameAlpha::from_black) {
        const auto bytes =
            alpha == FrameAlpha::none ? display_bytes(picture) : display_bytes_with_alpha(picture);
        return {bytes.begin(), bytes.end()};
    }
    const std::vector<std::uint16_t> words = display_words(picture, alpha);
    std::string bytes;
    bytes.reserve(words.size() * static_cast<std::size_t>(bits / 8));
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i % 4 == 3 && alpha == FrameAlpha::none)
            continue;
        if (bits == 8) {
            bytes += byte_of(words[i]);
            continue;
        }
        bytes += static_cast<char>(words[i] & 255u);
        bytes += static_cast<char>(words[i] >> 8u);
    }
    return bytes;
}
