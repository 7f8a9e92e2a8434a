#include "model/picture/prescaled.h"

#include <doctest/doctest.h>

namespace {
// Each pixel differs from its neighbours.
Picture original(int width, int height) {
    Picture picture{{width, height}, 3, Encoding::display, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.pixels.insert(picture.pixels.end(),
                                  {static_cast<float>(x), static_cast<float>(y), 1.0f});
    return picture;
}

Picture enlarged(const Picture& picture, int times) {
    Picture large{{picture.extent.width * times, picture.extent.height * times},
                  picture.channels,
                  picture.encoding,
                  {}};
    for (int y = 0; y < large.extent.height; ++y)
        for (int x = 0; x < large.extent.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                large.pixels.push_back(picture.pixels[picture.index(x / times, y / times) + c]);
    return large;
}
}  // namespace

TEST_CASE("the integer scale of an enlarged picture is detected, and the original restored") {
    const Picture picture = original(20, 15);
    for (int times = 1; times <= 8; ++times) {
        CAPTURE(times);
        CHECK(found_prescale(enlarged(picture, times)) == times);
        CHECK(without_prescale(enlarged(picture, times), times) == picture);
    }
    CHECK(found_prescale(enlarged(picture, 10)) == 5);
    CHECK(found_prescale(enlarged(picture, 9)) == 3);
}

TEST_CASE("one pixel that is not repeated disproves prescaling") {
    Picture large = enlarged(original(20, 15), 3);
    large.pixels[large.index(30, 22)] += 0.5f;
    CHECK(found_prescale(large) == 1);
}

TEST_CASE("a picture with few or no changes is not taken as prescaled") {
    Picture flat{{64, 64}, 1, Encoding::linear, std::vector<float>(64 * 64, 0.5f)};
    CHECK(found_prescale(flat) == 1);
    CHECK(found_prescale(enlarged(original(8, 30), 4)) == 1);  // 7 changes horizontally
    CHECK(found_prescale(enlarged(original(9, 9), 4)) == 4);
    CHECK(found_prescale(Picture{}) == 1);
}

TEST_CASE("a cropped enlargement keeps whole pixels of the original") {
    CHECK(extent_without_prescale({11, 7}, 3) == Extent{3, 2});
    CHECK(extent_without_prescale({2, 2}, 8) == Extent{1, 1});
    const Picture picture = without_prescale(original(11, 7), 3);
    CHECK(picture.extent == Extent{3, 2});
    CHECK(picture.pixels[picture.index(2, 1)] == 7.0f);  // the middle of 6, 7, 8
    CHECK(picture.pixels[picture.index(2, 1) + 1] == 4.0f);
    CHECK(without_prescale(original(2, 2), 8).pixels == std::vector<float>{1.0f, 1.0f, 1.0f});
}
