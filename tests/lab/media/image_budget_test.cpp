#include "lab/media/image_budget.h"

#include <doctest/doctest.h>

TEST_CASE("the images of a look take at most 1 GiB in total") {
    Image image;
    image.file = "a.png";
    image.format = Format::rgba32f;  // 16 bytes per texel
    Picture picture;
    picture.extent = {4096, 4096};  // 2^24 texels
    ImageBudget floats;
    for (int i = 0; i < 4; ++i)
        CHECK(floats.take(image, picture).has_value());
    picture.extent = {1, 1};
    const auto refused = floats.take(image, picture);
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error().front().file == "a.png");
    picture.extent = {4096, 4096};
    image.format = Format::rgba8;  // 4 bytes per texel
    ImageBudget bytes;
    for (int i = 0; i < 16; ++i)
        CHECK(bytes.take(image, picture).has_value());
    CHECK_FALSE(bytes.take(image, picture).has_value());
}
