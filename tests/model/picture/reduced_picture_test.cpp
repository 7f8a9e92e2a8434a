#include "model/picture/reduced_picture.h"

#include <doctest/doctest.h>

TEST_CASE("a reduced pixel is the mean of the pixels that it covers") {
    Picture picture{.extent = {4, 2},
                    .channels = 1,
                    .encoding = Encoding::display,
                    .pixels = {0.0f, 0.5f, 1.0f, 1.0f, 0.25f, 0.25f, 0.0f, 1.0f}};
    const Picture small = reduced_picture(picture, 2);
    CHECK(small.extent == Extent{2, 1});
    CHECK(small.encoding == Encoding::display);
    CHECK(small.pixels == std::vector<float>{0.25f, 0.75f});
}

TEST_CASE("sizes that do not divide keep the shape, and thin pictures keep a row") {
    Picture picture{.extent = {1000, 3}, .channels = 3, .pixels = std::vector<float>(9000, 0.5f)};
    const Picture small = reduced_picture(picture, 384);
    CHECK(small.extent == Extent{384, 1});
    CHECK(small.pixels == std::vector<float>(384 * 3, 0.5f));
}

TEST_CASE("a small picture is unchanged") {
    const Picture picture{.extent = {2, 1}, .channels = 1, .pixels = {0.0f, 1.0f}};
    CHECK(reduced_picture(picture, 2) == picture);
}
