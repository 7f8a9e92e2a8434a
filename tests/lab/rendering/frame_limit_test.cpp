#include "lab/rendering/frame_limit.h"

#include <doctest/doctest.h>

#include <algorithm>

TEST_CASE("the points get half the time of the rest of a frame, or two display frames") {
    // 0.4 s for points of 0.25 s, 0.2 s for the rest: 0.1 s is allowed, a quarter of 0.4.
    CHECK(longest_frame({.wall_seconds = 0.6, .beam_seconds = 0.4, .span_seconds = 0.25}) ==
          doctest::Approx(0.0625));
    // Nothing else takes time: 1/30 s of 0.5 s is allowed.
    CHECK(longest_frame({.wall_seconds = 0.5, .beam_seconds = 0.5, .span_seconds = 0.25}) ==
          doctest::Approx(1.0 / 60.0));
    CHECK(longest_frame({.wall_seconds = 0.2, .beam_seconds = 0.2, .span_seconds = 0.2}) ==
          doctest::Approx(2.0 / 60.0));
}

TEST_CASE("a fast machine, or one without timings, may cover a quarter of a second") {
    CHECK(longest_frame({.wall_seconds = 0.0167, .beam_seconds = 0.001, .span_seconds = 0.0167}) ==
          0.25);
    CHECK(longest_frame({.wall_seconds = 0.6, .beam_seconds = 0.0, .span_seconds = 0.25}) == 0.25);
    CHECK(longest_frame({}) == 0.25);
}

TEST_CASE("frames of a slow machine do not grow from one to the next") {
    // One second of the signal takes two seconds to draw, everything else 0.3 s.
    double span = 1.0 / 60.0;
    double wall = 0.0;
    for (int frame = 0; frame < 50; ++frame) {
        const double beam = 2.0 * span;
        wall = 0.3 + beam;
        span = std::min(wall, longest_frame({wall, beam, span}));
    }
    CHECK(wall == doctest::Approx(0.45));
}
