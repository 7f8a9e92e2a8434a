#include "io/video/frame_bytes.h"

#include "model/picture/display_bytes.h"

#include <doctest/doctest.h>

namespace {
using Numbers = std::vector<int>;

Numbers bytes_of(const std::string& text) {
    Numbers numbers;
    for (const char letter : text)
        numbers.push_back(static_cast<unsigned char>(letter));
    return numbers;
}

// Two pixels: the bottom row is stored first.
RawPicture two_rows() {
    return {{1, 2},
            4,
            Encoding::display,
            RawPicture::Floats{0.5f, 0.25f, 0.0f, 0.5f,  //
                               1.0f, 2.0f, -1.0f, 1.0f}};
}
}  // namespace

TEST_CASE("frames of 8 bits are the bytes of PNG files") {
    const RawPicture picture = two_rows();
    const auto rgb = display_bytes(picture);
    CHECK(frame_bytes(picture, 8, FrameAlpha::none) == std::string(rgb.begin(), rgb.end()));
    CHECK(bytes_of(frame_bytes(picture, 8, FrameAlpha::own)) ==
          Numbers{255, 255, 0, 255, 128, 64, 0, 128});
}

TEST_CASE("frames of 16 bits have the low byte first") {
    // 0.5 is 32768 (0x8000), 0.25 is 16384 (0x4000).
    CHECK(bytes_of(frame_bytes(two_rows(), 16, FrameAlpha::none)) ==
          Numbers{255, 255, 255, 255, 0, 0, 0, 0x80, 0, 0x40, 0, 0});
    RawPicture linear = two_rows();
    linear.encoding = Encoding::linear;
    // IEC 61966-2-1: 0.5 is 1.055 * 0.5^(1/2.4) - 0.055 = 0.735357 of 65535 = 48192.
    CHECK(display_words(linear, FrameAlpha::own)[4] == 48192);
    CHECK(display_words(linear, FrameAlpha::own)[7] == 32768);
}

TEST_CASE("alpha from black keeps the picture over black") {
    const auto words = display_words(two_rows(), FrameAlpha::from_black);
    CHECK(std::vector<int>(words.begin() + 4, words.end()) == Numbers{65535, 32768, 0, 32768});
    const RawPicture black{{1, 1}, 4, Encoding::display, RawPicture::Bytes{0, 0, 0, 255}};
    CHECK(bytes_of(frame_bytes(black, 8, FrameAlpha::from_black)) == Numbers{0, 0, 0, 0});
}
