#include "io/pictures/caption.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace {
constexpr CaptionPosition place{.left = 4, .baseline = 40, .width = 120, .height = 32};

Picture written(const std::string& text) {
    Picture picture{{128, 56}, 3, Encoding::display, std::vector<float>(128 * 56 * 3, 0.0f)};
    REQUIRE(draw_caption(picture, place, text));
    return picture;
}

// The sum over the rows first .. last - 1.
double ink(const Picture& picture, int first, int last) {
    double sum = 0.0;
    for (int i = first * 128 * 3; i < last * 128 * 3; ++i)
        sum += picture.pixels[static_cast<std::size_t>(i)];
    return sum;
}
}  // namespace

TEST_CASE("a caption draws non-ASCII letters") {
    const Picture plain = written("e");
    const Picture accented = written("\xC3\xA9");  // U+00E9, e with an acute accent

    constexpr int top_of_small_letters = 20;
    CHECK(ink(plain, 0, top_of_small_letters) == 0.0);
    CHECK(ink(accented, 0, top_of_small_letters) > 5.0);
    CHECK(ink(accented, top_of_small_letters + 2, 56) ==
          doctest::Approx(ink(plain, top_of_small_letters + 2, 56)).epsilon(0.02));
}

TEST_CASE("a caption draws a replacement character for invalid UTF-8") {
    CHECK(ink(written("a\xFFz"), 0, 56) > ink(written("az"), 0, 56));
    CHECK(ink(written("a\xE2\x82"), 0, 56) > ink(written("a"), 0, 56));
}

TEST_CASE("a caption outside the picture draws nothing") {
    Picture small{{3, 3}, 4, Encoding::display, std::vector<float>(36, 0.0f)};

    CHECK(draw_caption(small, {.left = -500, .baseline = 900, .width = 400, .height = 30}, "far"));
    CHECK(std::ranges::all_of(small.pixels, [](float value) { return value == 0.0f; }));
}
