#include "graph/beam/merge_segments.h"

#include "about.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {
std::vector<Segment> joined(const Beam& beam, const BeamSpot& spot = {}) {
    std::vector<Segment> made;
    SegmentTints tints{beam.tints, {}};
    make_segments(beam, std::nullopt, made, tints);
    merge_segments(made, tints, spot);
    CHECK(tints.of_segments.size() == (beam.tints.empty() ? 0 : made.size()));
    return made;
}

// From x = -0.5 to 0.5 in `pieces` segments, 0.016 s long, with a total charge of 8.
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

TEST_CASE("a straight path at constant speed becomes one segment with the total charge and time") {
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

TEST_CASE("bends, changes of speed, current or colour and blanked moves separate segments") {
    Beam beam = straight(8);
    beam[4].y += 4e-6f;  // twice the allowed distance from the line
    CHECK(joined(beam).size() > 1);
    beam = straight(8);
    beam[4].x += 4e-6f;  // slower, then faster
    CHECK(joined(beam).size() > 1);
    beam = straight(8);
    beam[6].intensity = 0.0f;
    CHECK(joined(beam).size() == 2);
    beam = straight(8);
    beam[6].age_seconds += 0.0005f;  // the same charge in less time
    CHECK(joined(beam).size() > 1);
    beam = straight(8);
    beam.tints.assign(9, BeamTint{});
    CHECK(joined(beam).size() == 1);
    beam.tints[5] = {1.0f, 0.5f, 0.0f};
    CHECK(joined(beam).size() == 3);
}

TEST_CASE("a slow curve is split where it would leave its chord") {
    Beam beam;
    for (int i = 0; i <= 4000; ++i) {
        const float angle = 0.0005f * static_cast<float>(i);
        beam.push_back({std::cos(angle), std::sin(angle), 1.0f, 0.0f});
    }
    const auto made = joined(beam);
    // A chord of length c lies c c / 8 below the arc of a circle of radius 1. The tolerance of 2e-6
    // per axis, at most 2.83e-6, gives a chord of 0.0048 on an arc of length 2.
    CHECK(made.size() >= 420);
    CHECK(made.size() < 1500);
}

namespace {
constexpr double sigma = 0.002;  // half screens
constexpr BeamSpot spot{sigma, sigma};

// A beam with `count` points in a frame of 1/60 s, with a total charge of 4096.
template <class PlaceAt>
Beam evenly(int count, PlaceAt position_at) {
    Beam beam;
    for (int k = 1; k <= count; ++k) {
        const double share = static_cast<double>(k) / count;
        const std::array<double, 2> place = position_at(share);
        beam.push_back({static_cast<float>(place[0]), static_cast<float>(place[1]),
                        static_cast<float>(4096.0 / count),
                        static_cast<float>((1.0 - share) / 60.0)});
    }
    return beam;
}

Beam lissajous(int count) {
    return evenly(count, [](double share) -> std::array<double, 2> {
        const double turn = 2.0 * std::numbers::pi * share;
        return {0.84 * std::sin(5.0 * turn + 0.5), 0.84 * std::sin(4.0 * turn)};
    });
}

double charge_of(const std::vector<Segment>& segments) {
    double sum = 0.0;
    for (const Segment& segment : segments)
        sum += 0.5 * (static_cast<double>(segment.start_intensity) +
                      static_cast<double>(segment.end_intensity));
    return sum;
}

// The largest distance between a point and the merged beam at equal charge, relative to the allowed
// distance. That is 0.01 sigma, or 0.05 sigma on a segment up to half a sigma long.
double farthest(const Beam& beam, const std::vector<Segment>& merged) {
    double maximum = 0.0;
    double charge = 0.0;  // up to the point, and up to the segment
    double before = 0.0;
    std::size_t at = 0;
    for (std::size_t k = 1; k < beam.size(); ++k) {
        charge += static_cast<double>(beam[k].intensity);
        while (at + 1 < merged.size() &&
               before + static_cast<double>(merged[at].end_intensity) < charge)
            before += static_cast<double>(merged[at++].end_intensity);
        const Segment& on = merged[at];
        const double share = (charge - before) / static_cast<double>(on.end_intensity);
        const double x = std::lerp(static_cast<double>(on.x0), static_cast<double>(on.x1), share);
        const double y = std::lerp(static_cast<double>(on.y0), static_cast<double>(on.y1), share);
        const double off =
            std::hypot(x - static_cast<double>(beam[k].x), y - static_cast<double>(beam[k].y));
        const double length = std::hypot(static_cast<double>(on.x1) - static_cast<double>(on.x0),
                                         static_cast<double>(on.y1) - static_cast<double>(on.y0));
        maximum = std::max(maximum, off / (sigma * (length > 0.5 * sigma ? 0.01 : 0.05)));
    }
    return maximum;
}
}  // namespace

TEST_CASE("merging keeps the charge, the path within its tolerance, the ends and the time") {
    for (const int count : {512, 4096, 65536, 262144}) {
        CAPTURE(count);
        const Beam beam = lissajous(count);
        const auto merged = joined(beam, spot);
        CHECK(charge_of(merged) == about(4096.0 * (count - 1) / count, 1e-6));
        CHECK(farthest(beam, merged) < 1.02);  // charges are rounded to floats
        CHECK((merged.front().x0 == beam.front().x && merged.front().y0 == beam.front().y));
        CHECK((merged.back().x1 == beam.back().x && merged.back().y1 == beam.back().y));
        CHECK(merged.front().start_age == beam.front().age_seconds);
        CHECK(merged.back().end_age == 0.0f);
        for (std::size_t i = 1; i < merged.size(); ++i) {
            REQUIRE(merged[i].x0 == merged[i - 1].x1);
            REQUIRE(merged[i].y0 == merged[i - 1].y1);
            REQUIRE(merged[i].start_age == merged[i - 1].end_age);
        }
    }
}

TEST_CASE("the number of segments of a circle depends on its curvature, not on its points") {
    // A chord of length c lies c c / 8 r inside its circle: 0.007 to 0.0099 sigma.
    constexpr double r = 0.8;
    const auto pieces = [](double share) {
        return 2.0 * std::numbers::pi * r / std::sqrt(8.0 * r * share * sigma);
    };
    for (const int count : {16384, 262144}) {
        CAPTURE(count);
        const auto merged = joined(evenly(count,
                                          [](double share) -> std::array<double, 2> {
                                              const double turn = 2.0 * std::numbers::pi * share;
                                              return {r * std::cos(turn), r * std::sin(turn)};
                                          }),
                                   spot);
        CHECK(static_cast<double>(merged.size()) > pieces(0.0099));
        CHECK(static_cast<double>(merged.size()) < 1.03 * pieces(0.007) + 1.0);
    }
}

TEST_CASE("a path with jitter below 0.05 sigma is split at half a sigma") {
    constexpr double length = 0.4;
    constexpr int count = 65536;
    const auto trembling = [](double by) {
        return evenly(count, [by](double share) -> std::array<double, 2> {
            const double across = std::fmod(share * count, 2.0) < 0.5 ? by : -by;
            return {length * (share - 0.5), across * sigma};
        });
    };
    const auto merged = joined(trembling(0.015), spot);
    const double pieces = std::ceil(length / (0.5 * sigma));
    CHECK(static_cast<double>(merged.size()) >= pieces);
    CHECK(static_cast<double>(merged.size()) <= 1.01 * pieces);
    CHECK(charge_of(merged) == about(4096.0 * (count - 1) / count, 1e-6));
    // Larger jitter is kept, and negligible jitter is merged into one segment.
    CHECK(joined(trembling(0.03), spot).size() > count / 2);
    CHECK(joined(trembling(0.003), spot).size() == 1);
}

TEST_CASE("a changing current ends a segment when it has changed by 1 %") {
    constexpr int count = 2000;
    Beam beam = evenly(count, [](double share) -> std::array<double, 2> {
        return {1e-6 * share, 0.0};
    });
    double sum = 0.0;
    for (int k = 0; k < count; ++k) {  // by a factor of e in total
        beam[static_cast<std::size_t>(k)].intensity =
            static_cast<float>(std::exp(static_cast<double>(k) / count));
        if (k > 0)  // a segment's charge is the mean of its end points
            sum += 0.5 * (std::exp(static_cast<double>(k) / count) +
                          std::exp(static_cast<double>(k - 1) / count));
    }
    const auto merged = joined(beam, spot);
    CHECK(charge_of(merged) == about(sum, 1e-6));
    // Relative to the running mean the current deviates by half of its change. It changes by 0.01
    // per segment, plus or minus two samples and 0.001 of rounding of ages.
    CHECK(merged.size() >= 83);
    CHECK(merged.size() <= 111);
    for (std::size_t k = count / 2; k < beam.size(); ++k)
        beam[k].intensity = 2.0f * beam[count / 2 - 1].intensity;
    const float jump = beam[count / 2 - 1].x;
    CHECK(std::ranges::any_of(joined(beam, spot),
                              [&](const Segment& segment) { return segment.x1 == jump; }));
}

TEST_CASE("a blanked jump stays dark, however close its ends are") {
    Beam beam = evenly(1000, [](double share) -> std::array<double, 2> {
        return {0.1 * sigma * (share < 0.5 ? share : share + 0.2), 0.0};
    });
    beam[499].intensity = 0.0f;
    const auto merged = joined(beam, spot);
    REQUIRE(merged.size() == 2);
    CHECK(merged[0].x1 < merged[1].x0);
    CHECK(charge_of(merged) == about(4.096 * 998, 1e-6));
}

TEST_CASE("a horizontally wide spot hides only horizontal detail") {
    const auto zigzag = [](bool across) {
        return evenly(4096, [across](double share) -> std::array<double, 2> {
            const double off = std::fmod(share * 4096.0, 2.0) < 0.5 ? 0.0005 : 0.0;
            return across ? std::array{off, 0.5 * share} : std::array{0.5 * share, off};
        });
    };
    const BeamSpot wide{0.2, 1e-6};
    CHECK(joined(zigzag(true), wide).size() == 1);
    CHECK(joined(zigzag(false), wide).size() > 2000);
}
