#include "model/picture/raw_picture.h"

#include "model/picture/display_bytes.h"
#include "model/picture/flash_log.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {
// Every half float, in a picture with this number of channels.
RawPicture all_halves(int channels, Encoding encoding) {
    RawPicture raw{{256, 256 / channels}, channels, encoding, RawPicture::Halves()};
    auto& halves = std::get<RawPicture::Halves>(raw.pixels);
    halves.resize(raw.row_length() * static_cast<std::size_t>(raw.extent.height));
    for (std::size_t i = 0; i < halves.size(); ++i)
        halves[i] = static_cast<std::uint16_t>(i);
    return raw;
}

RawPicture all_bytes(Encoding encoding) {
    RawPicture raw{{16, 4}, 4, encoding, RawPicture::Bytes(256)};
    for (std::size_t i = 0; i < 256; ++i)
        std::get<RawPicture::Bytes>(raw.pixels)[i] = static_cast<std::uint8_t>(i);
    return raw;
}
}  // namespace

TEST_CASE("half floats are decoded as in IEEE 754") {
    // sign, 5 bits of exponent (bias 15), 10 bits of fraction
    CHECK(number_of(std::uint16_t{0x3c00}) == 1.0f);
    CHECK(number_of(std::uint16_t{0xc000}) == -2.0f);
    CHECK(number_of(std::uint16_t{0x3555}) == 0x1.554p-2f);
    CHECK(number_of(std::uint16_t{0x7bff}) == 65504.0f);
    CHECK(number_of(std::uint16_t{0x0001}) == 0x1p-24f);
    CHECK(number_of(std::uint16_t{0x7c00}) == std::numeric_limits<float>::infinity());
    CHECK(std::isnan(number_of(std::uint16_t{0x7e00})));
}

TEST_CASE("a raw picture read from GL is flipped vertically") {
    const RawPicture raw{{1, 3}, 1, Encoding::display, RawPicture::Bytes{51, 102, 255}};
    const Picture picture = picture_of(raw);
    CHECK(picture.extent == Extent{1, 3});
    CHECK(picture.encoding == Encoding::display);
    CHECK(picture.pixels[0] == 1.0f);
    CHECK(picture.pixels[1] == doctest::Approx(0.4));
    CHECK(picture.pixels[2] == doctest::Approx(0.2));
    CHECK(display_bytes(raw) ==
          std::vector<std::uint8_t>{255, 255, 255, 102, 102, 102, 51, 51, 51});
}

TEST_CASE("display bytes are the same as those of the float picture, for every value") {
    for (const Encoding encoding : {Encoding::linear, Encoding::display}) {
        for (const int channels : {1, 4}) {
            const RawPicture halves = all_halves(channels, encoding);
            CHECK(display_bytes(halves) == display_bytes(picture_of(halves)));
        }
        const RawPicture bytes = all_bytes(encoding);
        CHECK(display_bytes(bytes) == display_bytes(picture_of(bytes)));
    }
    const std::vector<std::uint8_t> shown = display_bytes(all_bytes(Encoding::display));
    CHECK(shown.front() == 192);  // the first of the last row
    CHECK(shown.back() == 62);    // the last pixel of the first row, before its alpha
}

TEST_CASE("flashes are counted from the same light as in the float picture") {
    for (const Encoding encoding : {Encoding::linear, Encoding::display}) {
        const RawPicture halves = all_halves(4, encoding);
        CHECK(cells_of(halves) == cells_of(picture_of(halves)));
        const RawPicture bytes = all_bytes(encoding);
        CHECK(cells_of(bytes) == cells_of(picture_of(bytes)));
    }
}
