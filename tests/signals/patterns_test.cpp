#include "signals/patterns.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

namespace {
std::vector<float> pixel(const Picture& picture, int x, int y) {
    const auto first = picture.pixels.begin() + static_cast<std::ptrdiff_t>(picture.index(x, y));
    return {first, first + picture.channels};
}
}  // namespace

TEST_CASE("the SMPTE bars stand in their order at 75 %") {
    const auto bars = make_pattern("smpte,size=700x480");
    REQUIRE(bars.has_value());
    const std::vector<std::vector<float>> expected{
        {.75f, .75f, .75f}, {.75f, .75f, 0}, {0, .75f, .75f}, {0, .75f, 0},
        {.75f, 0, .75f},    {.75f, 0, 0},    {0, 0, .75f}};
    for (int i = 0; i < 7; ++i)
        CHECK(pixel(*bars, 50 + 100 * i, 100) == expected[static_cast<std::size_t>(i)]);
    CHECK(pixel(*bars, 50, 340) == expected[6]);  // reversed blue bars
    CHECK(pixel(*bars, 150, 340) == std::vector<float>{0, 0, 0});
    CHECK(pixel(*bars, 180, 460) == std::vector<float>{1, 1, 1});
}

TEST_CASE("a ramp of 256 px holds each 8-bit code at its place") {
    const auto ramp = make_pattern("ramp,size=256x2");
    REQUIRE(ramp.has_value());
    for (int x : {0, 100, 255})
        CHECK(pixel(*ramp, x, 1)[0] == doctest::Approx((x + 0.5) / 256.0));
}

TEST_CASE("the checkerboard is half white") {
    const auto board = make_pattern("checker,size=64x32");
    REQUIRE(board.has_value());
    CHECK(std::count(board->pixels.begin(), board->pixels.end(), 1.0f) == 64 * 32 * 3 / 2);
}

TEST_CASE("a pattern's mistakes are named") {
    CHECK(make_pattern("smpt").error().front().message ==
          "there is no pattern 'smpt' (did you mean 'smpte'?)");
    for (const char* text :
         {"", "smpte,size=", "smpte,size=0x5", "smpte,size=99999x9", "smpte,color=1"})
        CHECK_FALSE(make_pattern(text).has_value());
}

TEST_CASE("every pattern that is listed can be made, and no two are the same") {
    std::set<std::vector<float>> seen;
    for (const PatternFacts& facts : all_patterns()) {
        const auto picture = make_pattern(facts.name + ",size=80x60");
        REQUIRE(picture.has_value());
        CHECK(seen.insert(picture->pixels).second);
    }
}
