#include "signals/drawing/drawing.h"

#include "signals/drawing/keyframe_order.h"
#include "signals/drawing/line_morph.h"
#include "signals/signal_making.h"

#include <algorithm>
#include <array>

namespace {
Stroke square(double side, BeamPosition middle = {0.0, 0.0}) {
    const double half = 0.5 * side;
    return {.points = {{middle[0] - half, middle[1] - half},
                       {middle[0] + half, middle[1] - half},
                       {middle[0] + half, middle[1] + half},
                       {middle[0] - half, middle[1] + half}},
            .is_closed = true};
}

bool is_at(const BeamPosition& place, double x, double y, double tolerance = 1e-9) {
    return std::hypot(place[0] - x, place[1] - y) <= tolerance;
}

bool goes_through(const std::vector<BeamPosition>& line, const BeamPosition& place) {
    return std::any_of(line.begin(), line.end(),
                       [&](const BeamPosition& point) { return is_at(point, place[0], place[1]); });
}

std::string drawing_refusal(const std::string& text) {
    const auto drawing = parse_drawing(text);
    REQUIRE_FALSE(drawing.has_value());
    return drawing.error().front().message;
}

std::string refused_signal(const std::string& text) {
    const auto signal = make_signal(parse_spec(text).value(), {});
    REQUIRE_FALSE(signal.has_value());
    return signal.error().front().message;
}

// The smallest and the largest x with light.
std::array<float, 2> reach_of(const Beam& beam) {
    std::array<float, 2> reach{9.0f, -9.0f};
    for (const BeamPoint& point : beam)
        if (point.intensity > 0.0f)
            reach = {std::min(reach[0], point.x), std::max(reach[1], point.x)};
    return reach;
}
}  // namespace

TEST_CASE("a drawing's text parses to the same drawing") {
    const Drawing drawing{{{square(1.0), {{{-0.5, 0.25}, {0.1234, -1.5}, {0.0, 0.0}}, true, false}},
                           {},
                           {square(0.5)}}};
    CHECK(to_text(drawing) ==
          "[L-0.5 -0.5 0.5 -0.5 0.5 0.5 -0.5 0.5z;S-0.5 0.25 0.1234 -1.5 0 0][]"
          "[L-0.25 -0.25 0.25 -0.25 0.25 0.25 -0.25 0.25z]");
    CHECK(parse_drawing(to_text(drawing)).value() == drawing);
    CHECK(to_text({{{{{{0.00001, -0.00001}, {1.0 / 3.0, 0.0}}}}}}) == "[L0 0 0.3333 0]");
    const std::string spec = "drawing:strokes=" + to_text(drawing);
    CHECK(to_string(parse_spec(spec).value()) == spec);
}

TEST_CASE("an error in a drawing's text gives its stroke and keyframe") {
    CHECK(drawing_refusal("") == "expected at least one keyframe, such as the empty one []");
    CHECK(drawing_refusal("L0 0 1 1") == "each keyframe must be enclosed in [ and ]");
    CHECK(drawing_refusal("[L0 0 1 1") == "each keyframe must be enclosed in [ and ]");
    CHECK(drawing_refusal("[][L0 0 1 1;Q0 0]").starts_with("stroke 2 of keyframe 2: expected L"));
    CHECK(drawing_refusal("[L0 0 1]").starts_with("stroke 1 of keyframe 1: expected pairs"));
    CHECK(drawing_refusal("[L]").starts_with("stroke 1 of keyframe 1: expected pairs"));
    CHECK(drawing_refusal("[L0 nan]").starts_with("stroke 1 of keyframe 1: expected pairs"));
    CHECK(drawing_refusal("[L0 1e9]").starts_with("stroke 1 of keyframe 1: expected pairs"));
    std::string keyframes;
    for (std::size_t i = 0; i <= max_keyframes; ++i)
        keyframes += "[]";
    CHECK(drawing_refusal(keyframes) == "too many keyframes; the limit is 100");
    Drawing huge{{{{}}}};
    huge.keyframes[0][0].points.resize(max_drawing_points + 1);
    CHECK(drawing_refusal(to_text(huge)) == "too many points; the limit is 20000");
}

TEST_CASE("an imported drawing is fitted to the screen, and a drawing to scale is unchanged") {
    Drawing drawing{{{{{{10.0, 20.0}, {30.0, 20.0}, {30.0, 25.0}}}}}};
    CHECK(to_scale(drawing, 1.6) == drawing);
    drawing.is_to_scale = false;
    const Drawing scaled = to_scale(drawing, 1.6);
    CHECK(scaled.is_to_scale);
    const auto& points = scaled.keyframes[0][0].points;
    CHECK(is_at(points[0], -0.8, -0.2));
    CHECK(is_at(points[2], 0.8, 0.2));
}

TEST_CASE("a smooth stroke passes through all its points") {
    Stroke stroke{{{-0.7, 0.1}, {-0.5, 0.6}, {-0.45, 0.6}, {0.2, -0.8}, {0.9, 0.0}}, true};
    for (const bool is_closed : {false, true}) {
        stroke.is_closed = is_closed;
        const auto line = line_of(stroke);
        for (const BeamPosition& point : stroke.points)
            CHECK(goes_through(line, point));
        CHECK(is_at(line.front(), -0.7, 0.1));
        CHECK(is_at(line.back(), is_closed ? -0.7 : 0.9, is_closed ? 0.1 : 0.0));
    }
}

TEST_CASE("between equidistant points the curve is a Catmull-Rom spline") {
    const Stroke stroke{{{-0.6, 0.0}, {-0.2, 0.3}, {0.2, 0.0}, {0.6, 0.3}}, true};
    const CurveSpan middle = curve_of(stroke)[1];
    // Halfway the curve is (-p0 + 9 p1 + 9 p2 - p3) / 16; its slope at p1 is (p2 - p0) / 2.
    const double x = (middle[0][0] + 3.0 * middle[1][0] + 3.0 * middle[2][0] + middle[3][0]) / 8.0;
    const double y = (middle[0][1] + 3.0 * middle[1][1] + 3.0 * middle[2][1] + middle[3][1]) / 8.0;
    CHECK(is_at({x, y}, 0.0, (9.0 * 0.3 - 0.3) / 16.0));
    CHECK(is_at(middle[1], -0.2 + 0.8 / 6.0, 0.3));
}

TEST_CASE("the curve has no loops between unevenly spaced points") {
    const Stroke stroke{{{-0.9, 0.0}, {0.0, 0.0}, {0.02, 0.01}, {0.02, 0.9}}, true};
    const auto line = line_of(stroke);
    for (std::size_t i = 1; i < line.size(); ++i) {
        CHECK(line[i][0] >= line[i - 1][0] - 0.002);
        CHECK(line[i][1] >= line[i - 1][1] - 0.002);
    }
}

TEST_CASE("duplicate points and single points are valid strokes") {
    CHECK(line_of({{{0.1, 0.1}, {0.1, 0.1}, {0.3, 0.1}}, true}).size() > 2);
    CHECK(line_of({{{0.1, 0.1}}, true}) == std::vector<BeamPosition>{{0.1, 0.1}});
    CHECK(line_of({{{0.1, 0.1}, {0.1, 0.1}}, false, true}).size() == 1);
    CHECK(line_of({}).empty());
    CHECK(morph_of({}, {}).from.empty());
    CHECK(morph_of({{{0.1, 0.1}}}, square(1.0)).at(0.0).size() > 3);
}

TEST_CASE("simplification removes points within the tolerance") {
    std::vector<BeamPosition> corner;
    for (int i = 0; i <= 100; ++i)
        corner.push_back({std::min(i, 60) / 100.0, 0.001 * (i % 2) + std::max(i - 60, 0) / 100.0});
    const auto simple = simplified(corner, 0.003);
    CHECK(simple.size() == 3);
    for (const BeamPosition& point : corner)
        CHECK(distance_to_line(point, simple) <= 0.003);
    CHECK(simplified(corner, 1e-6).size() > 60);
}

TEST_CASE("halfway between two squares is their mean, with four corners") {
    const auto half = morph_of(square(0.4, {-0.2, 0.0}), square(1.2, {0.2, 0.4})).at(0.5);
    REQUIRE(half.size() == 5);
    const std::vector<BeamPosition> expected = line_of(square(0.8, {0.0, 0.2}));
    for (std::size_t i = 0; i < 5; ++i)
        CHECK(is_at(half[i], expected[i][0], expected[i][1]));
}

TEST_CASE("a morph matches points by arc length and keeps every corner") {
    const Stroke bent{{{0.0, 0.0}, {0.3, 0.0}, {0.3, 0.1}}};                // its corner is at 3/4
    const Stroke zigzag{{{0.0, 0.5}, {0.1, 0.5}, {0.1, 0.6}, {0.3, 0.6}}};  // at 1/4 and 1/2
    const LineMorph morph = morph_of(bent, zigzag);
    REQUIRE(morph.from.size() == 5);  // two ends, and the corners of both
    CHECK(is_at(morph.from[1], 0.1, 0.0));
    CHECK(is_at(morph.from[2], 0.2, 0.0));
    CHECK(is_at(morph.from[3], 0.3, 0.0));
    CHECK(is_at(morph.to[1], 0.1, 0.5));
    CHECK(is_at(morph.to[3], 0.2, 0.6));
    CHECK(is_at(morph.at(0.25)[3], 0.275, 0.15));
}

TEST_CASE("closed strokes are aligned before a morph, also with reversed points") {
    Stroke other = square(1.0);
    std::rotate(other.points.begin(), other.points.begin() + 2, other.points.end());
    std::reverse(other.points.begin(), other.points.end());
    const auto half = morph_of(square(0.5), other).at(0.5);
    CHECK(std::abs(length_of(half) - 4.0 * 0.75) < 1e-9);
}

TEST_CASE("a stroke without a counterpart grows from its centre") {
    const Keyframe one{square(0.4)};
    const Keyframe two{square(0.4), {{{0.2, 0.5}, {0.8, 0.7}}}};
    const auto morphs = morphs_of(one, two);
    REQUIRE(morphs.size() == 2);
    for (const BeamPosition& place : morphs[1].at(0.0))
        CHECK(is_at(place, 0.5, 0.6));
    CHECK(is_at(morphs[1].at(0.5)[0], 0.35, 0.55));
    CHECK(is_at(morphs[1].at(1.0)[1], 0.8, 0.7));
    CHECK(morphs_of(two, one)[1].at(1.0)[0] == morphs[1].at(0.0)[0]);
}

TEST_CASE("a stroke deleted in a copy shrinks, and the others stay unchanged") {
    const Keyframe all{{{{-0.5, 0.5}, {0.5, 0.5}}}, square(0.4), {{{-0.5, -0.5}, {0.5, -0.5}}}};
    for (std::size_t gone = 0; gone < all.size(); ++gone) {
        Keyframe fewer = all;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(gone));
        const auto shrinking = morphs_of(all, fewer);
        const auto growing = morphs_of(fewer, all);
        REQUIRE(shrinking.size() == all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            const bool is_gone = i == gone;
            CHECK((length_of(shrinking[i].at(1.0)) < 1e-9) == is_gone);
            CHECK((shrinking[i].from == shrinking[i].to) == !is_gone);
            CHECK(growing[i].at(0.0) == shrinking[i].at(1.0));
        }
    }
}

TEST_CASE("keyframes are held and morphed in the order of the play mode") {
    const auto order = [](KeyframePlay play) {
        KeyframeOrder made = order_of(play, 3, 1);
        made.hold_seconds = 1.0;
        made.morph_seconds = 2.0;
        return made;
    };
    const auto keyframes_at = [](const KeyframeOrder& made, double seconds) {
        const auto moment = made.at(seconds);
        return std::array{made.begin_of(moment.step), made.end_of(moment.step)};
    };
    const KeyframeOrder loop = order(KeyframePlay::loop);
    CHECK(loop.at(0.5).share == 0.0);
    CHECK(std::abs(loop.at(2.0).share - 0.5) < 1e-12);
    CHECK(std::abs(loop.at(1.5).share - 0.15625) < 1e-12);  // 3/16 - 2/64
    CHECK(keyframes_at(loop, 7.5) == std::array<std::size_t, 2>{2, 0});
    CHECK(keyframes_at(loop, 9.5) == std::array<std::size_t, 2>{0, 1});
    const KeyframeOrder back = order(KeyframePlay::back_and_forth);
    CHECK(keyframes_at(back, 7.5) == std::array<std::size_t, 2>{2, 1});
    CHECK(keyframes_at(back, 10.5) == std::array<std::size_t, 2>{1, 0});
    CHECK(keyframes_at(back, 12.5) == std::array<std::size_t, 2>{0, 1});
    const KeyframeOrder once = order(KeyframePlay::once);
    CHECK(keyframes_at(once, 4.5) == std::array<std::size_t, 2>{1, 2});
    CHECK(keyframes_at(once, 99.0) == std::array<std::size_t, 2>{1, 2});
    CHECK(once.at(99.0).share == 1.0);
    const KeyframeOrder still = order(KeyframePlay::still);
    CHECK(keyframes_at(still, 42.0) == std::array<std::size_t, 2>{1, 1});
    KeyframeOrder even = loop;
    even.is_eased = false;
    CHECK(std::abs(even.at(1.5).share - 0.25) < 1e-12);
}

TEST_CASE("the beam draws keyframes and their morphs") {
    // A line with length 0.4, held for 0.5 s, grows to 1.2 within a second.
    const auto signal = signal_of(
        "drawing:strokes=[L-0.2 0.1 0.2 0.1][L-0.6 0.1 0.6 0.1],hold=0.5,morph=1,ease=even,"
        "beam_speed=200,refresh=50");
    const auto at = [&](double seconds) { return beam_of(*signal, {seconds, seconds + 0.02}); };
    CHECK(std::abs(reach_of(at(0.2))[1] - 0.2f) < 1e-5f);
    CHECK(std::abs(reach_of(at(1.0))[1] - 0.4f) < 1e-5f);
    CHECK(std::abs(reach_of(at(1.0))[0] + 0.4f) < 0.01f);
    CHECK(std::abs(reach_of(at(1.6))[1] - 0.6f) < 1e-5f);
    CHECK(std::abs(reach_of(at(2.5))[1] - 0.4f) < 1e-5f);  // on the way back
    // 0.8 half screens at 200 per second take 4 ms of full current.
    CHECK(std::abs(charge_of(at(1.0)) / (0.004 * 4096.0 * 60.0) - 1.0) < 1e-4);
}

TEST_CASE("an empty keyframe is dark, and strokes grow from it") {
    const auto signal = signal_of("drawing:strokes=[][L-0.6 0 0.6 0],hold=0.5,morph=1,ease=even");
    CHECK(charge_of(beam_of(*signal, {0.1, 0.4})) == 0.0);
    CHECK(std::abs(reach_of(beam_of(*signal, {1.0, 1.0 + 1.0 / 60.0}))[1] - 0.3f) < 0.01f);
    CHECK(beam_of(*signal_of("drawing:strokes=[]"), {0.0, 1.0}).empty());
}

TEST_CASE("a long drawing is drawn completely at a lower refresh rate") {
    const auto signal =
        signal_of("drawing:strokes=[L-0.9 0 0.9 0 -0.9 0.1 0.9 0.1],beam_speed=20,play=still");
    // 1.8 + 1.8028 + 1.8 at 20 per second take 0.27 s.
    const Beam beam = beam_of(*signal, {0.0, 0.2701});
    CHECK(std::abs(charge_of(beam) / (0.270139 * 4096.0 * 60.0) - 1.0) < 1e-3);
}

TEST_CASE("a drawing needs either strokes or a file") {
    CHECK(refused_signal("drawing").find("expected a file") != std::string::npos);
    CHECK(refused_signal("drawing:a.svg,strokes=[]") ==
          "drawing: 'file' and 'strokes' can't be used together");
    CHECK(refused_signal("drawing:a.svg").find("nothing to draw") != std::string::npos);
    CHECK(refused_signal("drawing:strokes=[L0 0 1]").find("stroke 1 of keyframe 1") !=
          std::string::npos);
}
