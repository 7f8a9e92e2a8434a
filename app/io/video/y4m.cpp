#include "io/video/y4m.h"

#include <fmt/format.h>

#include <cassert>

namespace {
// BT.709, items 3.2 to 3.4, in units of 1/10000: Y = 0.2126 R + 0.7152 G + 0.0722 B, Cb = (B - Y) /
// 1.8556, Cr = (R - Y) / 1.5748. Item 3.5 gives the codes of black, white and grey.
constexpr int red = 2126;
constexpr int green = 7152;
constexpr int blue = 722;
constexpr int whole = red + green + blue;
constexpr int levels = 255;
constexpr int luma_span = 219;
constexpr int chroma_span = 224;
constexpr int darkest = 16;
constexpr int grey = 128;
constexpr int blue_span = 2 * (whole - blue);
constexpr int red_span = 2 * (whole - red);

// `offset` + numerator / denominator, rounded; never negative.
template <int Denominator, int Offset>
std::uint8_t rounded(int numerator) {
    return static_cast<std::uint8_t>(
        static_cast<unsigned>(numerator + Offset * Denominator + Denominator / 2) / Denominator);
}
}  // namespace

std::string y4m_header(Extent extent, const FrameRateFraction& rate) {
    return fmt::format("YUV4MPEG2 W{} H{} F{} Ip A1:1 C444 XCOLORRANGE=LIMITED\n", extent.width,
                       extent.height, rate.text(':'));
}

std::string y4m_frame(Extent extent, std::span<const std::uint8_t> rgb) {
    constexpr std::string_view start = "FRAME\n";
    const auto count =
        static_cast<std::size_t>(extent.width) * static_cast<std::size_t>(extent.height);
    assert(rgb.size() == 3 * count);
    std::string frame(start.size() + 3 * count, '\0');
    start.copy(frame.data(), start.size());
    auto* const luma = reinterpret_cast<std::uint8_t*>(frame.data() + start.size());
    std::uint8_t* const cb = luma + count;
    std::uint8_t* const cr = cb + count;
    const std::uint8_t* pixel = rgb.data();
    for (std::size_t i = 0; i < count; ++i, pixel += 3) {
        const int r = pixel[0];
        const int g = pixel[1];
        const int b = pixel[2];
        const int light = red * r + green * g + blue * b;
        luma[i] = rounded<whole * levels, darkest>(luma_span * light);
        cb[i] = rounded<blue_span * levels, grey>(chroma_span * (whole * b - light));
        cr[i] = rounded<red_span * levels, grey>(chroma_span * (whole * r - light));
    }
    return frame;
}
