#include "model/comparison.h"

#include "about.h"
#include "model/difference.h"

TEST_CASE("a difference is seen absolute, relative to the other, or squared") {
    CHECK(difference_of(0.75, 0.5, DifferenceMeasure::absolute) == 0.25);
    CHECK(difference_of(0.5, 0.75, DifferenceMeasure::absolute) == 0.25);
    CHECK(difference_of(0.75, 0.5, DifferenceMeasure::relative) == 0.5);
    CHECK(difference_of(0.5, -0.25, DifferenceMeasure::relative) == 3.0);
    CHECK(difference_of(0.005, 0.0, DifferenceMeasure::relative) == about(0.5, 1e-12));
    CHECK(difference_of(0.75, 0.5, DifferenceMeasure::squared) == 0.0625);
}

TEST_CASE("half the light is matched by one stop; darkness by nothing") {
    CHECK(matching_stops(0.5, 0.25) == 1.0);
    CHECK(matching_stops(0.125, 0.5) == -2.0);
    CHECK_FALSE(matching_stops(0.5, 0.0));
    CHECK_FALSE(matching_stops(0.0, 0.5));
}

TEST_CASE("sums of differences come to means over components and shares of pixels") {
    // 4 pixels of 3 components: a half apart in six of them.
    const Distances distances =
        distances_of({.absolute = 3.0, .squares = 1.5, .largest = 0.5, .beyond = 2}, {2, 2}, 3);
    CHECK(distances.mean == 0.25);
    CHECK(distances.rms == about(0.353553390593, 1e-9));
    CHECK(distances.psnr_db == about(9.03089987, 1e-8));  // 10 log10 8
    CHECK(distances.share_beyond == 0.5);
    CHECK(distances.largest == 0.5);
}
