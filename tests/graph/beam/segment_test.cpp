#include "graph/beam/segment.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {
std::vector<Segment> segments(const Beam& beam, std::optional<BeamPoint> before = std::nullopt) {
    std::vector<Segment> made{{9, 9, 9, 9, 9, 9, 9, 9}};  // of the previous frame, to be dropped
    SegmentTints none;
    make_segments(beam, before, made, none);
    CHECK(none.of_segments.empty());
    return made;
}
}  // namespace

TEST_CASE("n points give n - 1 segments, plus one from the previous frame") {
    const Beam beam{{0, 0, 1, 0.3f}, {1, 0, 2, 0.2f}, {1, 1, 3, 0.1f}};
    CHECK(segments(beam) ==
          std::vector<Segment>{{0, 0, 1, 0, 2, 2, 0.3f, 0.2f}, {1, 0, 1, 1, 2, 3, 0.2f, 0.1f}});
    const auto joined = segments(beam, BeamPoint{-1, 0, 4, 0.4f});
    REQUIRE(joined.size() == 3);
    CHECK(joined.front() == Segment{-1, 0, 0, 0, 1, 1, 0.4f, 0.3f});
    CHECK(segments({}, BeamPoint{}).empty());
    CHECK(segments({{0, 0, 1, 0}}).empty());
}

TEST_CASE("a constant current stays constant with unevenly spaced points") {
    // A charge of 8 per second.
    const auto made =
        segments({{0, 0, 8, 4}, {1, 0, 8, 3}, {2, 0, 4, 2.5f}, {3, 0, 4, 2}, {4, 0, 16, 0}});
    REQUIRE(made.size() == 4);
    for (const Segment& segment : made) {
        const float charge = 8.0f * (segment.start_age - segment.end_age);
        CHECK(segment.start_intensity == charge);
        CHECK(segment.end_intensity == charge);
    }
}

TEST_CASE("the segment to a blanked point is not drawn, and the next one has full current") {
    const auto made = segments({{0, 0, 1, 0}, {1, 0, 0, 0}, {1, 1, 5, 0}});
    CHECK(made == std::vector<Segment>{{1, 0, 1, 1, 5, 5, 0, 0}});
}

TEST_CASE("a non-finite point only interrupts the line") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float far = std::numeric_limits<float>::infinity();
    const auto made =
        segments({{0, 0, 1, 0}, {nan, 0, 1, 0}, {0, far, 1, 0}, {1, 1, 1, 0}, {2, 1, 1, 0}});
    CHECK(made == std::vector<Segment>{{1, 1, 2, 1, 1, 1, 0, 0}});
}

TEST_CASE("evenly spaced points have equal charge, even with rounded ages") {
    Beam beam;
    constexpr int count = 262144;
    for (int k = 1; k <= count; ++k)
        beam.push_back({static_cast<float>(k) / count, 0.0f, 1.0f / 64.0f,
                        static_cast<float>((1.0 - static_cast<double>(k) / count) / 60.0)});
    for (const Segment& segment : segments(beam))
        REQUIRE(segment.start_intensity == 1.0f / 64.0f);
}
