#include "graph/segment.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

namespace {
std::vector<Segment> segments(const Beam& beam, std::optional<BeamPoint> before = std::nullopt) {
    std::vector<Segment> made{{9, 9, 9, 9, 9, 9, 9, 9}};  // of the frame before, to be dropped
    SegmentTints none;
    make_segments(beam, before, made, none);
    CHECK(none.of_segments.empty());
    return made;
}
}  // namespace

TEST_CASE("n points make n - 1 segments, and one more to the frame before") {
    const Beam beam{{0, 0, 1, 0.3f}, {1, 0, 2, 0.2f}, {1, 1, 3, 0.1f}};
    CHECK(segments(beam) ==
          std::vector<Segment>{{0, 0, 1, 0, 2, 2, 0.3f, 0.2f}, {1, 0, 1, 1, 2, 3, 0.2f, 0.1f}});
    const auto joined = segments(beam, BeamPoint{-1, 0, 4, 0.4f});
    REQUIRE(joined.size() == 3);
    CHECK(joined.front() == Segment{-1, 0, 0, 0, 1, 1, 0.4f, 0.3f});
    CHECK(segments({}, BeamPoint{}).empty());
    CHECK(segments({{0, 0, 1, 0}}).empty());
}

TEST_CASE("a steady current is steady also where points come unevenly") {
    // A charge of 8 a second.
    const auto made =
        segments({{0, 0, 8, 4}, {1, 0, 8, 3}, {2, 0, 4, 2.5f}, {3, 0, 4, 2}, {4, 0, 16, 0}});
    REQUIRE(made.size() == 4);
    for (const Segment& segment : made) {
        const float charge = 8.0f * (segment.start_age - segment.end_age);
        CHECK(segment.start_intensity == charge);
        CHECK(segment.end_intensity == charge);
    }
}

TEST_CASE("the way to a blanked point is not drawn, the way on from it is fully lit") {
    const auto made = segments({{0, 0, 1, 0}, {1, 0, 0, 0}, {1, 1, 5, 0}});
    CHECK(made == std::vector<Segment>{{1, 0, 1, 1, 5, 5, 0, 0}});
}

TEST_CASE("a point that is not finite breaks the line and nothing more") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float far = std::numeric_limits<float>::infinity();
    const auto made =
        segments({{0, 0, 1, 0}, {nan, 0, 1, 0}, {0, far, 1, 0}, {1, 1, 1, 0}, {2, 1, 1, 0}});
    CHECK(made == std::vector<Segment>{{1, 1, 2, 1, 1, 1, 0, 0}});
}

namespace {
std::vector<Segment> joined(const Beam& beam) {
    std::vector<Segment> made;
    SegmentTints tints{beam.tints, {}};
    make_segments(beam, std::nullopt, made, tints);
    join_straight(made, tints);
    CHECK(tints.of_segments.size() == (beam.tints.empty() ? 0 : made.size()));
    return made;
}

// From -0.5 to 0.5 in `pieces`, 0.016 s long, with a charge of 8 in all.
Beam straight(int pieces) {
    Beam beam;
    for (int i = 0; i <= pieces; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(pieces);
        beam.push_back({share - 0.5f, 0.3f * share, 8.0f / static_cast<float>(pieces),
                        0.016f * (1.0f - share)});
    }
    return beam;
}
}  // namespace

TEST_CASE("what goes straight on at one speed is one segment with all of the charge and time") {
    for (const int pieces : {1, 2, 7, 4000}) {
        CAPTURE(pieces);
        const auto made = joined(straight(pieces));
        REQUIRE(made.size() == 1);
        const Segment& whole = made.front();
        CHECK((whole.x0 == -0.5f && whole.y0 == 0.0f && whole.x1 == 0.5f && whole.y1 == 0.3f));
        CHECK(std::abs(whole.start_intensity - 8.0f) < 1e-4f);
        CHECK(whole.end_intensity == whole.start_intensity);
        CHECK((whole.start_age == 0.016f && whole.end_age == 0.0f));
    }
    CHECK(joined({{0.2f, 0.1f, 1, 3}, {0.2f, 0.1f, 1, 2}, {0.2f, 0.1f, 1, 1}}).size() == 1);
}

TEST_CASE("a bend, another speed, current or colour and a blanked way part segments") {
    Beam beam = straight(8);
    beam[4].y += 4e-6f;  // twice as far from the line as may be
    CHECK(joined(beam).size() > 1);
    beam = straight(8);
    beam[4].x += 4e-6f;  // slower, then faster
    CHECK(joined(beam).size() > 1);
    beam = straight(8);
    beam[6].intensity = 0.0f;
    CHECK(joined(beam).size() == 2);
    beam = straight(8);
    beam[6].age_seconds += 0.0005f;  // as much charge in less time
    CHECK(joined(beam).size() > 1);
    beam = straight(8);
    beam.tints.assign(9, BeamTint{});
    CHECK(joined(beam).size() == 1);
    beam.tints[5] = {1.0f, 0.5f, 0.0f};
    CHECK(joined(beam).size() == 3);
}

TEST_CASE("a slow curve is cut where it would leave its chord") {
    Beam beam;
    for (int i = 0; i <= 4000; ++i) {
        const float angle = 0.0005f * static_cast<float>(i);
        beam.push_back({std::cos(angle), std::sin(angle), 1.0f, 0.0f});
    }
    const auto made = joined(beam);
    // A chord of length c lies c c / 8 below the arc of a circle of radius 1: 2e-6 on each axis, at
    // most 2.83e-6, is 0.0048 of an arc 2 long.
    CHECK(made.size() >= 420);
    CHECK(made.size() < 1500);
}
