// The limits of WCAG 2.1, success criterion 2.3.1, with sequences whose flashes can be counted by
// hand.
#include "model/picture/flash_log.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace {
using Cells = std::function<Light(int x, int y, int frame)>;

/// The highest counts over the frames of a picture, at 60 fps.
Flashes counted(const Cells& picture, int frames = 120) {
    FlashCounter counter;
    Flashes maximum;
    constexpr auto columns = static_cast<std::size_t>(flash_cells.width);
    std::vector<Light> cells(columns * static_cast<std::size_t>(flash_cells.height));
    for (int frame = 0; frame < frames; ++frame) {
        for (int y = 0; y < flash_cells.height; ++y)
            for (int x = 0; x < flash_cells.width; ++x)
                cells[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)] =
                    picture(x, y, frame);
        const Flashes now = counter.add(frame / 60.0, cells);
        maximum = {std::max(maximum.general, now.general), std::max(maximum.red, now.red)};
    }
    return maximum;
}

Light grey(double level) {
    const auto number = static_cast<float>(level);
    return {number, number, number};
}

/// Half a period dark, then half a period light; `period` in frames.
Cells square(int period, Light dark, Light light) {
    return [=](int, int, int frame) { return frame % period * 2 < period ? dark : light; };
}
}  // namespace

TEST_CASE("three flashes per second are within the limit, and four exceed it") {
    const Flashes three = counted(square(20, grey(0.0), grey(1.0)));
    CHECK(three.general == 3);
    CHECK_FALSE(three.is_beyond_limit());
    const Flashes four = counted(square(15, grey(0.0), grey(1.0)));
    CHECK(four.general == 4);
    CHECK(four.is_beyond_limit());
    CHECK(counted(square(2, grey(0.0), grey(1.0))).general == 30);
    CHECK(counted(square(2, grey(0.0), grey(1.0))).red == 0);
}

TEST_CASE("a flash needs a luminance change of 10 % and a dark state below 0.8") {
    CHECK(counted(square(10, grey(0.40), grey(0.50))).general == 6);
    CHECK(counted(square(10, grey(0.40), grey(0.499))).general == 0);
    CHECK(counted(square(10, grey(0.79), grey(1.0))).general == 6);
    CHECK(counted(square(10, grey(0.80), grey(1.0))).general == 0);
}

TEST_CASE("relative luminance weights the colours: green flashes, but blue does not") {
    // A change of 0.0722 of the maximum luminance is not a flash, one of 0.7152 is. Red, 0.2126,
    // also counts as a red flash.
    CHECK(counted(square(10, {0, 0, 0}, {0, 0, 1})) == Flashes{0, 0});
    CHECK(counted(square(10, {0, 0, 0}, {0, 1, 0})) == Flashes{6, 0});
    CHECK(counted(square(10, {0, 0, 0}, {1, 0, 0})) == Flashes{6, 6});
}

TEST_CASE("a red flash needs saturated red and a change of more than 20 of 320") {
    // 20 / 320 = 1 / 16 of pure red; 0.0133 of luminance
    CHECK(counted(square(10, {0, 0, 0}, {0.063f, 0, 0})).red == 6);
    CHECK(counted(square(10, {0, 0, 0}, {0.0625f, 0, 0})).red == 0);
    // R / (R + G + B) is 0.8, then 0.79
    CHECK(counted(square(10, {0, 0, 0}, {0.80f, 0.20f, 0})).red == 6);
    CHECK(counted(square(10, {0, 0, 0}, {0.79f, 0.21f, 0})).red == 0);
}

TEST_CASE("a slow rise and fall are one flash, regardless of the number of frames") {
    const auto triangle = [](int, int, int frame) {
        const double phase = frame % 30 / 30.0;
        return grey(phase < 0.5 ? 2.0 * phase : 2.0 - 2.0 * phase);
    };
    CHECK(counted(triangle).general == 2);
    const auto stairs = [](int, int, int frame) { return grey(std::min(frame / 100.0, 1.0)); };
    CHECK(counted(stairs).general == 0);  // a rise alone is half a flash
}

TEST_CASE("several rises in a row count once") {
    // A rise of 0.3 in three steps with small dips between them, then a fall: one pair in 20
    // frames.
    const auto bumpy = [](int, int, int frame) {
        constexpr std::array levels{0.0, 0.15, 0.1, 0.3, 0.25, 0.4};
        const int place = frame % 20;
        return grey(levels[static_cast<std::size_t>(std::min(place, 5))]);
    };
    CHECK(counted(bumpy).general == 3);
}

TEST_CASE("flashes count if they cover more than a quarter of a field of 10 degrees") {
    const auto part = [](int width, int height) {
        return [=](int x, int y, int frame) {
            const bool flashes = x >= 5 && x < 5 + width && y >= 20 && y < 20 + height;
            return grey(flashes && frame % 10 < 5 ? 1.0 : 0.0);
        };
    };
    // A field has 16 x 12 cells, a quarter 48.
    CHECK(counted(part(8, 6)).general == 0);
    CHECK(counted(part(7, 7)).general == 6);
    CHECK(counted(part(48, 1)).general == 0);  // 16 of them in any field
    CHECK(counted(part(48, 4)).general == 6);
}

TEST_CASE("a flash stops counting after one second") {
    FlashCounter counter;
    const std::vector<Light> dark(48 * 36, grey(0.0));
    const std::vector<Light> light(48 * 36, grey(1.0));
    counter.add(0.0, dark);
    counter.add(0.1, light);
    CHECK(counter.add(0.2, dark).general == 1);
    CHECK(counter.add(1.05, dark).general == 1);
    CHECK(counter.add(1.15, dark).general == 0);
}

TEST_CASE("a warning reports how often, how long and when pictures exceed the flash limit") {
    const auto log_of = [](int period) {
        FlashLog log;
        for (int frame = 0; frame < 90; ++frame) {
            const float level = frame % period * 2 < period ? 0.0f : 1.0f;
            log.add({{7, 5}, 3, Encoding::display, std::vector<float>(7 * 5 * 3, level)},
                    (frame + 1) / 60.0);
        }
        return log;
    };
    CHECK_FALSE(log_of(20).warning());
    const FlashLog six = log_of(10);
    CHECK(six.maximum() == Flashes{6, 0});
    REQUIRE(six.warning());
    // Changes occur in frames 5, 10, .. from 0: the eighth, so the fourth flash, is in frame 40.
    CHECK(six.warning()->find("up to 6 times a second (0 in red)") != std::string::npos);
    CHECK(six.warning()->find("50 frames from 0.68 s to 1.50 s are above it.") !=
          std::string::npos);
}

TEST_CASE("cells average linear light, not display values, and a NaN counts as black") {
    // White and black columns of one pixel: half of the light.
    Picture picture{{96, 36}, 3, Encoding::display, std::vector<float>(96 * 36 * 3, 0.0f)};
    for (std::size_t i = 0; i < 96 * 36; i += 2)
        for (std::size_t channel = 0; channel < 3; ++channel)
            picture.pixels[i * 3 + channel] = 1.0f;
    CHECK(std::abs(cells_of(picture)[0][0] - 0.5f) < 1e-5f);
    // A display value of 0.5 is 0.2140 in linear light.
    std::fill(picture.pixels.begin(), picture.pixels.end(), 0.5f);
    CHECK(std::abs(cells_of(picture)[500][2] - 0.21404f) < 1e-4f);
    std::fill(picture.pixels.begin(), picture.pixels.end(), std::nanf(""));
    CHECK(cells_of(picture)[7] == Light{0, 0, 0});
}
