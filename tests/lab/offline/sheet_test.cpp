#include "lab/offline/sheet.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {
Picture plain(Extent extent, float value, Encoding encoding = Encoding::display) {
    Picture picture{extent, 4, encoding, {}};
    picture.pixels.assign(static_cast<std::size_t>(extent.width * extent.height) * 4, value);
    return picture;
}

int count_of(const Picture& sheet, float value) {
    int count = 0;
    for (std::size_t i = 0; i < sheet.pixels.size(); i += 3)
        count += sheet.pixels[i] == value ? 1 : 0;
    return count;
}
}  // namespace

TEST_CASE("a sheet contains every picture completely, in rows from the top left") {
    const Extent cell{60, 30};
    const auto sheet = sheet_of(
        {{"one", plain(cell, 0.25f)}, {"two", plain(cell, 0.5f)}, {"three", plain(cell, 0.75f)}},
        2);

    REQUIRE(sheet);
    for (const float value : {0.25f, 0.5f, 0.75f})
        CHECK(count_of(*sheet, value) == 60 * 30);
    const auto first = [&](float value) {
        for (std::size_t i = 0; i < sheet->pixels.size(); i += 3)
            if (sheet->pixels[i] == value)
                return std::array{static_cast<int>(i / 3) % sheet->extent.width,
                                  static_cast<int>(i / 3) / sheet->extent.width};
        return std::array{-1, -1};
    };
    CHECK(first(0.5f)[1] == first(0.25f)[1]);
    CHECK(first(0.5f)[0] >= first(0.25f)[0] + 60);
    CHECK(first(0.75f)[0] == first(0.25f)[0]);
    CHECK(first(0.75f)[1] >= first(0.25f)[1] + 30);
}

TEST_CASE("a sheet encodes linear light for the display") {
    const auto sheet = sheet_of({{"a", plain({20, 20}, 0.5f, Encoding::linear)}}, 1);

    REQUIRE(sheet);
    // sRGB, IEC 61966-2-1: 1.055 * 0.5^(1/2.4) - 0.055
    CHECK(count_of(*sheet, static_cast<float>(1.055 * std::pow(0.5, 1.0 / 2.4) - 0.055)) == 400);
}

TEST_CASE("a caption is below its picture and within its width") {
    const Extent cell{80, 30};
    const auto bare = sheet_of({{"", plain(cell, 0.25f)}, {"", plain(cell, 0.25f)}}, 2);
    const auto captioned = sheet_of(
        {{"A name that is far too long for this", plain(cell, 0.25f)}, {"", plain(cell, 0.25f)}},
        2);

    REQUIRE(bare);
    REQUIRE(captioned);
    int changed = 0;
    int rightmost = 0;
    for (std::size_t i = 0; i < bare->pixels.size(); i += 3)
        if (bare->pixels[i] != captioned->pixels[i]) {
            ++changed;
            rightmost = std::max(rightmost, static_cast<int>(i / 3) % bare->extent.width);
        }
    CHECK(changed > 50);
    CHECK(rightmost < bare->extent.width / 2);
}

TEST_CASE("a sheet above the size limit of pictures is refused") {
    const auto sheet =
        sheet_of({{"a", plain({9000, 10}, 0.0f)}, {"b", plain({9000, 10}, 0.0f)}}, 2);

    REQUIRE_FALSE(sheet);
    CHECK(sheet.error().front().message.find("16384") != std::string::npos);
}
