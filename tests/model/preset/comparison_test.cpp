#include "model/preset/comparison.h"

#include "about.h"
#include "model/picture/difference.h"

#include <limits>

TEST_CASE("a difference is measured absolute, relative to the reference, or squared") {
    CHECK(difference_of(0.75, 0.5, DifferenceMeasure::absolute) == 0.25);
    CHECK(difference_of(0.5, 0.75, DifferenceMeasure::absolute) == 0.25);
    CHECK(difference_of(0.75, 0.5, DifferenceMeasure::relative) == 0.5);
    CHECK(difference_of(0.5, -0.25, DifferenceMeasure::relative) == 3.0);
    CHECK(difference_of(0.005, 0.0, DifferenceMeasure::relative) == about(0.5, 1e-12));
    CHECK(difference_of(0.75, 0.5, DifferenceMeasure::squared) == 0.0625);
}

TEST_CASE("brightness is matched in stops, and black has no match") {
    CHECK(matching_stops(0.5, 0.25) == 1.0);
    CHECK(matching_stops(0.125, 0.5) == -2.0);
    CHECK_FALSE(matching_stops(0.5, 0.0));
    CHECK_FALSE(matching_stops(0.0, 0.5));
}

TEST_CASE("a difference is amplified by the largest power of two that does not exceed white") {
    CHECK(gain_to_see(0.25) == 4.0);
    CHECK(gain_to_see(0.3) == 2.0);
    CHECK(gain_to_see(1.0) == 1.0);
    CHECK(gain_to_see(0.0) == 1.0);
    CHECK(gain_to_see(1e-9) == 65536.0);
    CHECK(gain_to_see(std::numeric_limits<double>::infinity()) == 1.0);
    const Picture first{
        {2, 1}, 4, Encoding::display, {0.5f, 0.25f, 0.0f, 1.0f, 1.0f, 0.0f, 0.5f, 0.0f}};
    const Picture second{
        {2, 1}, 4, Encoding::display, {0.25f, 0.25f, 0.125f, 0.0f, 0.0f, 0.0f, 0.5f, 1.0f}};
    const Picture apart = difference_picture(first, second, 2.0);
    CHECK(apart.extent == Extent{2, 1});
    CHECK(apart.pixels == std::vector<float>{0.5f, 0.0f, 0.25f, 2.0f, 0.0f, 0.0f});
}

TEST_CASE("sums of differences become means over components and shares of pixels") {
    // 4 pixels of 3 components: six of them differ by 0.5.
    const Distances distances =
        distances_of({.absolute = 3.0, .squares = 1.5, .largest = 0.5, .beyond = 2}, {2, 2}, 3);
    CHECK(distances.mean == 0.25);
    CHECK(distances.rms == about(0.353553390593, 1e-9));
    CHECK(distances.psnr_db == about(9.03089987, 1e-8));  // 10 log10 8
    CHECK(distances.share_beyond == 0.5);
    CHECK(distances.largest == 0.5);
}
