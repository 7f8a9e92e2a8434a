#include "io/video/y4m.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

TEST_CASE("a y4m header contains size, frame rate and range") {
    CHECK(y4m_header({320, 181}, {30000, 1001}) ==
          "YUV4MPEG2 W320 H181 F30000:1001 Ip A1:1 C444 XCOLORRANGE=LIMITED\n");
}

TEST_CASE("y4m planes are rounded values of BT.709") {
    std::vector<std::uint8_t> rgb;
    for (int r = 0; r < 256; r += 15)
        for (int g = 0; g < 256; g += 17)
            for (int b = 0; b < 256; b += 5) {
                rgb.push_back(static_cast<std::uint8_t>(r));
                rgb.push_back(static_cast<std::uint8_t>(g));
                rgb.push_back(static_cast<std::uint8_t>(b));
            }
    const std::size_t count = rgb.size() / 3;
    const std::string frame = y4m_frame({static_cast<int>(count), 1}, rgb);
    REQUIRE(frame.size() == 6 + rgb.size());
    CHECK(frame.starts_with("FRAME\n"));
    int wrong = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto channel = [&](std::size_t c) { return rgb[3 * i + c] / 255.0; };
        // ITU-R BT.709-6, items 3.2, 3.3, 3.4
        const double y = 0.2126 * channel(0) + 0.7152 * channel(1) + 0.0722 * channel(2);
        const double cb = (channel(2) - y) / 1.8556;
        const double cr = (channel(0) - y) / 1.5748;
        const auto stored = [&](std::size_t plane) {
            return static_cast<unsigned char>(frame[6 + plane * count + i]);
        };
        constexpr double half = 0.5 + 1e-9;
        wrong += std::abs(stored(0) - (219.0 * y + 16.0)) > half ? 1 : 0;
        wrong += std::abs(stored(1) - (224.0 * cb + 128.0)) > half ? 1 : 0;
        wrong += std::abs(stored(2) - (224.0 * cr + 128.0)) > half ? 1 : 0;
    }
    CHECK(wrong == 0);
}

TEST_CASE("y4m black is 16, white is 235, and grey has neutral chroma") {
    const std::vector<std::uint8_t> rgb{0, 0, 0, 255, 255, 255, 128, 128, 128};
    const std::string frame = y4m_frame({3, 1}, rgb);
    CHECK(frame.substr(6) == std::string("\x10\xeb\x7e\x80\x80\x80\x80\x80\x80"));
}
