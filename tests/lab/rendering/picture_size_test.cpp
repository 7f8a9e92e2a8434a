#include "lab/rendering/picture_size.h"

#include <doctest/doctest.h>

TEST_CASE("the render size follows the view or is fixed, and both can be scaled") {
    CHECK(PictureSize{}.room({801, 600}) == Extent{801, 600});
    CHECK(PictureSize{true, {320, 240}}.room({801, 600}) == Extent{801, 600});
    CHECK(PictureSize{false, {320, 240}}.room({801, 600}) == Extent{320, 240});
    CHECK(PictureSize{true, {}, 0.25}.scaled({801, 600}) == Extent{200, 150});
    CHECK(PictureSize{true, {}, 0.25}.scaled({1, 1}) == Extent{1, 1});
    CHECK(PictureSize{false, {320, 240}, 2.0}.scaled({320, 240}) == Extent{640, 480});
}

TEST_CASE("a new render size is to be chosen, and a chosen one does not follow the view") {
    CHECK(PictureSize{}.is_to_be_chosen());
    const PictureSize chosen = fixed_in(PictureSize{true, {}, 0.5}, {801, 600});
    CHECK_FALSE(chosen.is_to_be_chosen());
    CHECK_FALSE(chosen.follows_view);
    CHECK(chosen.has_shape());  // a look from another program keeps its source's shape in it
    CHECK(chosen.room({100, 100}) == Extent{801, 600});
    CHECK(chosen.scaled(chosen.room({100, 100})) == Extent{401, 300});
    const PictureSize exact{false, {320, 240}};
    CHECK_FALSE(exact.has_shape());
}
