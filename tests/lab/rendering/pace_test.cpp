#include "lab/rendering/pace.h"

#include "lab/window/window_state.h"

#include <doctest/doctest.h>

TEST_CASE("a picture is slow once no frame has come within 1/30 s for two seconds") {
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

TEST_CASE("what rests, is capped, or waited once is not slow") {
    Pace pace;
    for (int frame = 0; frame < 100; ++frame)
        pace.expect(0.05, false);
    pace.expect(60.0, true);
    CHECK_FALSE(pace.is_slow());
    CHECK(FrameRate{.cap = 60.0}.wants_30(144.0));
    CHECK_FALSE(FrameRate{.cap = 30.0}.wants_30(144.0));
    CHECK_FALSE(FrameRate{.cap = 0.0}.wants_30(24.0));
}

TEST_CASE("half the size is offered only where the passes take half of a slow frame") {
    Pace pace;
    for (int frame = 0; frame < 39; ++frame)
        pace.expect(0.05, true);
    CHECK_FALSE(pace.is_slow_by_passes(45.0));  // not yet two seconds
    for (int frame = 0; frame < 3; ++frame)
        pace.expect(0.05, true);
    CHECK(pace.is_slow_by_passes(45.0));
    CHECK(pace.is_slow_by_passes(25.1));  // of 50 ms
    CHECK_FALSE(pace.is_slow_by_passes(24.9));
    CHECK_FALSE(pace.is_slow_by_passes(0.0));  // the driver tells no times
    for (int frame = 0; frame < 40; ++frame)
        pace.expect(0.2, true);
    CHECK_FALSE(pace.is_slow_by_passes(45.0));  // now the rest takes more
    CHECK(pace.is_slow_by_passes(120.0));
}

TEST_CASE(
    "a frame that was drawn for longer than a second counts at once, a rest of that length never") {
    Pace pace;
    for (int frame = 0; frame < 100; ++frame)
        pace.add(1.0 / 60.0);
    pace.add(1.8);
    CHECK(pace.frames_a_second() == doctest::Approx(60.0));
    pace.add(1.8, true);
    CHECK(pace.frames_a_second() == doctest::Approx(1.0 / 1.8));
}
