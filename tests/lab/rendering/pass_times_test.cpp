#include "lab/rendering/pass_times.h"

#include <doctest/doctest.h>

TEST_CASE("the times of the latest 120 frames are stored, oldest first") {
    PassTimes times;
    CHECK(times.frames() == 0);
    CHECK(times.current_total() == 0.0);
    for (int frame = 1; frame <= 150; ++frame)
        times.add({1.0 * frame, 0.5});
    CHECK(times.frames() == 120);
    CHECK(times.passes() == 2);
    CHECK(times.milliseconds(0, 0) == 31.0);
    CHECK(times.milliseconds(0, 119) == 150.0);
    CHECK(times.total(119) == 150.5);
    CHECK(times.longest_total() == 150.5);
    CHECK(times.current_total() == 141.0);  // of frames 131 to 150: 140.5 on average, plus 0.5
}

TEST_CASE("another number of passes clears the times") {
    PassTimes times;
    times.add({1.0, 2.0});
    times.add({3.0});
    CHECK(times.frames() == 1);
    CHECK(times.longest_total() == 3.0);
}
