#include "lab/rendering/pace.h"

#include "lab/window/frame_rate.h"

#include <doctest/doctest.h>

TEST_CASE("a picture is slow after two seconds without a frame within 1/30 s") {
    Pace pace;
    for (int frame = 0; frame < 39; ++frame)
        pace.expect(0.05, true);
    CHECK_FALSE(pace.is_slow());
    pace.expect(0.05, true);  // 40 times 1/20 s
    pace.expect(0.05, true);
    CHECK(pace.is_slow());
    pace.expect(1.0 / 30.0, true);
    CHECK_FALSE(pace.is_slow());
}

TEST_CASE("a static or capped picture, or a single wait, is not slow") {
    Pace pace;
    for (int frame = 0; frame < 100; ++frame)
        pace.expect(0.05, false);
    pace.expect(60.0, true);
    CHECK_FALSE(pace.is_slow());
    CHECK(FrameRate{.cap = 60.0}.wants_30(144.0));
    CHECK_FALSE(FrameRate{.cap = 30.0}.wants_30(144.0));
    CHECK_FALSE(FrameRate{.cap = 0.0}.wants_30(24.0));
}

TEST_CASE("half the size is offered only if the passes take half of a slow frame") {
    Pace pace;
    for (int frame = 0; frame < 39; ++frame)
        pace.expect(0.05, true);
    CHECK_FALSE(pace.is_slow_by_passes(45.0));  // less than two seconds
    for (int frame = 0; frame < 3; ++frame)
        pace.expect(0.05, true);
    CHECK(pace.is_slow_by_passes(45.0));
    CHECK(pace.is_slow_by_passes(25.1));  // of 50 ms
    CHECK_FALSE(pace.is_slow_by_passes(24.9));
    CHECK_FALSE(pace.is_slow_by_passes(0.0));  // the driver has no timings
    for (int frame = 0; frame < 40; ++frame)
        pace.expect(0.2, true);
    CHECK_FALSE(pace.is_slow_by_passes(45.0));  // now the rest of the frame takes more
    CHECK(pace.is_slow_by_passes(120.0));
}

TEST_CASE("a gap above one second counts only if it was spent drawing") {
    Pace pace;
    for (int frame = 0; frame < 100; ++frame)
        pace.add(1.0 / 60.0);
    pace.add(1.8);
    CHECK(pace.frames_per_second() == doctest::Approx(60.0));
    pace.add(1.8, true);
    CHECK(pace.frames_per_second() == doctest::Approx(1.0 / 1.8));
}

TEST_CASE("a frame that spans several updates counts once, with their whole time") {
    Pace pace;
    for (int update = 0; update < 4; ++update)
        pace.update(0.5, update < 3, true);
    CHECK(pace.frames_per_second() == doctest::Approx(0.5));
    CHECK(pace.start() == 1);
}
