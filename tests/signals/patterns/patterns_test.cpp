#include "signals/patterns/patterns.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace {
std::vector<float> pixel_of(const Picture& picture, int x, int y) {
    const auto first = picture.pixels.begin() + static_cast<std::ptrdiff_t>(picture.index(x, y));
    return {first, first + picture.channels};
}
}  // namespace

TEST_CASE("the SMPTE bars have the standard order at 75 %") {
    const auto bars = make_pattern("smpte,size=700x480");
    REQUIRE(bars.has_value());
    const std::vector<std::vector<float>> expected{
        {.75f, .75f, .75f}, {.75f, .75f, 0}, {0, .75f, .75f}, {0, .75f, 0},
        {.75f, 0, .75f},    {.75f, 0, 0},    {0, 0, .75f}};
    for (int i = 0; i < 7; ++i)
        CHECK(pixel_of(*bars, 50 + 100 * i, 100) == expected[static_cast<std::size_t>(i)]);
    CHECK(pixel_of(*bars, 50, 340) == expected[6]);  // reversed blue bars
    CHECK(pixel_of(*bars, 150, 340) == std::vector<float>{0, 0, 0});
    CHECK(pixel_of(*bars, 180, 460) == std::vector<float>{1, 1, 1});
    // -I and +Q as 8-bit codes, and PLUGE steps of 4 % around black between the sixth bar's thirds.
    const auto codes = [&bars](int x) {
        std::vector<int> values;
        for (const float part : pixel_of(*bars, x, 460))
            values.push_back(static_cast<int>(std::lround(part * 255.0f)));
        return values;
    };
    CHECK(codes(60) == std::vector<int>{0, 33, 76});
    CHECK(codes(310) == std::vector<int>{50, 0, 106});
    CHECK(codes(440) == std::vector<int>{0, 0, 0});
    CHECK(codes(550) == std::vector<int>{0, 0, 0});
    CHECK(codes(590) == std::vector<int>{10, 10, 10});
    CHECK(codes(650) == std::vector<int>{0, 0, 0});
    CHECK(pixel_of(*bars, 250, 340) == expected[4]);  // magenta, cyan and grey below, black between
    CHECK(pixel_of(*bars, 450, 340) == expected[2]);
    CHECK(pixel_of(*bars, 650, 340) == expected[0]);
}

TEST_CASE("a 256 px ramp has each 8-bit code at its position") {
    const auto ramp = make_pattern("ramp,size=256x2");
    REQUIRE(ramp.has_value());
    for (int x : {0, 100, 255})
        CHECK(pixel_of(*ramp, x, 1)[0] == doctest::Approx((x + 0.5) / 256.0));
}

TEST_CASE("half of the checkerboard is white") {
    const auto board = make_pattern("checker,size=64x32");
    REQUIRE(board.has_value());
    CHECK(std::count(board->pixels.begin(), board->pixels.end(), 1.0f) == 64 * 32 * 3 / 2);
}

TEST_CASE("an invalid pattern gives a specific error") {
    CHECK(make_pattern("smpt").error().front().message ==
          "unknown pattern 'smpt' (did you mean 'smpte'?)");
    for (const char* text :
         {"", "smpte,size=", "smpte,size=0x5", "smpte,size=99999x9", "smpte,color=1"})
        CHECK_FALSE(make_pattern(text).has_value());
}

TEST_CASE("every listed pattern can be made, and all differ") {
    std::set<std::vector<float>> pictures;
    for (const PatternInfo& info : all_patterns()) {
        CAPTURE(info.name);
        const auto picture = make_pattern(info.name + ",size=80x60");
        REQUIRE(picture.has_value());
        CHECK(picture->extent == Extent{80, 60});
        CHECK(pictures.insert(picture->pixels).second);
        CHECK_FALSE(info.help.empty());
    }
}

TEST_CASE("a moving pattern depends only on the time, and the others do not move") {
    for (const PatternInfo& info : all_patterns()) {
        CAPTURE(info.name);
        const std::string text = info.name + ",size=96x72";
        CHECK(is_moving_pattern(text) == info.moves);
        const auto now = make_pattern(text, 1.5);
        CHECK(now->pixels == make_pattern(text, 1.5)->pixels);
        CHECK((now->pixels != make_pattern(text, 2.5)->pixels) == info.moves);
    }
    CHECK_FALSE(is_moving_pattern("glyph-rian"));
}

TEST_CASE("the glyph rain is linear light with heads above 1") {
    const auto rain = make_pattern("glyph-rain,size=320x180", 3.0);
    REQUIRE(rain.has_value());
    CHECK(rain->encoding == Encoding::linear);
    const float brightest = *std::max_element(rain->pixels.begin(), rain->pixels.end());
    CHECK(brightest > 1.1f);
    CHECK(brightest < 2.0f);
    CHECK(*std::min_element(rain->pixels.begin(), rain->pixels.end()) >= 0.0f);
}

TEST_CASE("the pixel-art harbour has 320 x 240 pixels in 16 colours, and scales by whole pixels") {
    const auto harbour = make_pattern("harbour");
    REQUIRE(harbour.has_value());
    REQUIRE(harbour->extent == Extent{320, 240});
    std::set<std::vector<float>> colors;
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 320; ++x)
            colors.insert(pixel_of(*harbour, x, y));
    CHECK(colors.size() == 16);
    const auto twice = make_pattern("harbour,size=640x480");
    for (int i = 0; i < 200; ++i)
        CHECK(pixel_of(*twice, 3 * i, 2 * i) == pixel_of(*harbour, 3 * i / 2, i));
}

TEST_CASE("the zone plate has r / width periods per pixel, finest at its sides") {
    const auto plate = make_pattern("zone-plate,size=256x256");
    REQUIRE(plate.has_value());
    CHECK(pixel_of(*plate, 128, 128)[0] == doctest::Approx(1.0));
    // pi r^2 / 256 is a whole number of half turns where r^2 is a multiple of 256.
    CHECK(pixel_of(*plate, 128 + 16, 128)[0] == doctest::Approx(0.0));
    CHECK(pixel_of(*plate, 128 + 32, 128)[0] == doctest::Approx(1.0));
    CHECK(pixel_of(*plate, 0, 128)[0] == doctest::Approx(1.0));
    CHECK(pixel_of(*plate, 1, 128)[0] < 0.01f);
}

TEST_CASE("the dot pattern has one lit pixel, and the grid's circle touches top and bottom") {
    const auto dot = make_pattern("dot,size=64x48");
    CHECK(std::count(dot->pixels.begin(), dot->pixels.end(), 1.0f) == 3);
    CHECK(pixel_of(*dot, 32, 24)[0] == 1.0f);
    const auto grid = make_pattern("grid,size=640x480");
    CHECK(pixel_of(*grid, 320, 1)[0] == doctest::Approx(1.0));
    CHECK(pixel_of(*grid, 320, 478)[0] == doctest::Approx(1.0));
    CHECK(pixel_of(*grid, 320 - 239, 240)[0] == doctest::Approx(1.0));
}

TEST_CASE("the terminal pattern has 80 x 25 characters of 8 x 16 pixels") {
    const auto page = make_pattern("terminal");
    REQUIRE(page.has_value());
    CHECK(page->extent == Extent{640, 400});
    // The 'A' in the first line: pixels of the font, with its bar four rows down.
    CHECK(pixel_of(*page, 2 * 8 + 1, 2 * 4)[1] > 0.8f);
    CHECK(pixel_of(*page, 2 * 8 + 3, 0)[1] > 0.8f);
    CHECK(pixel_of(*page, 0, 0)[1] == 0.0f);
}

TEST_CASE("an interlaced pattern interleaves the latest field with the previous one") {
    constexpr int height = 48;
    const auto at = [](int field) {
        return make_pattern("glyph-rain,size=64x48", std::max(field, 0) / 60.0).value();
    };
    std::array<int, 2> changes{};  // by the field's parity
    for (int field = 0; field < 240; ++field) {
        const Picture latest = at(field);
        const Picture before = at(field - 1);
        if (field > 0 && latest.pixels == before.pixels)
            continue;
        ++changes[static_cast<std::size_t>(field % 2)];
        const Picture woven = make_pattern("glyph-rain,size=64x48i", field / 60.0).value();
        for (int y = 0; y < height; ++y) {
            const Picture& of = y % 2 == field % 2 ? latest : before;
            const auto first = static_cast<std::ptrdiff_t>(woven.index(0, y));
            CHECK(std::equal(
                woven.pixels.begin() + first,
                woven.pixels.begin() + static_cast<std::ptrdiff_t>(woven.index(0, y + 1)),
                of.pixels.begin() + first));
        }
    }
    CHECK(changes[0] > 1);
    CHECK(changes[1] > 0);
    CHECK(make_pattern("smpte,size=64x48i").value() == make_pattern("smpte,size=64x48").value());
    CHECK_FALSE(make_pattern("smpte,size=64x48p").has_value());
}
