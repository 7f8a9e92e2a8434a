#include "signals/beam/beam_input.h"
#include "signals/signal_making.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>

namespace {
std::vector<BeamInputPoint> read_text(std::string_view text, std::size_t piece) {
    BeamInputReader reader({}, "stdin");
    std::vector<BeamInputPoint> points;
    for (; !text.empty(); text.remove_prefix(std::min(piece, text.size())))
        reader.take(text.substr(0, piece), points);
    reader.finish(points);
    return points;
}

void append_float(std::string& bytes, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>(bits >> shift & 255);
}
}  // namespace

TEST_CASE("text lines are parsed the same for any chunk size") {
    const std::string text = "# a dot\n0.5 -0.25 1 0.01\r\n\n 1\t2 0\n-1 1e-1 0.5 2";
    const std::vector<BeamInputPoint> expected{
        {0.5f, -0.25f, 1.0f, 0.01}, {1.0f, 2.0f, 0.0f, 1.0 / 245760.0}, {-1.0f, 0.1f, 0.5f, 2.0}};
    for (std::size_t piece = 1; piece <= text.size(); ++piece)
        REQUIRE(read_text(text, piece) == expected);
}

TEST_CASE("the first invalid line is reported with its number, and valid lines are read") {
    BeamInputReader reader({}, "stdin");
    std::vector<BeamInputPoint> points;
    const std::string huge(5000000, '7');
    for (const std::string& line :
         {std::string("0 0 1"), std::string("0 nan 1"), huge, std::string("1 2"),
          std::string("0 0 1 -1"), std::string("0 0 1 1 1"), std::string("1 1 1")})
        reader.take(line + "\n", points);
    CHECK(points.size() == 2);
    CHECK(reader.bad_count() == 5);
    CHECK(to_string(*reader.problem()) == "stdin:2: error: 'y' must be a number, got 'nan'");
}

TEST_CASE("raw points are parsed the same for any chunk size, and NaN points are skipped") {
    std::string bytes;
    for (const float value : {0.5f, -0.5f, 1.0f, 0.0f, std::nanf(""), 1.0f, -1.0f, 0.25f, 0.0f})
        append_float(bytes, value);
    const std::vector<BeamInputPoint> expected{{0.5f, -0.5f, 1.0f, 0.01},
                                               {-1.0f, 0.25f, 0.0f, 0.01}};
    for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
        BeamInputReader reader({.is_raw = true, .channels = 3, .seconds = 0.01}, "stdin");
        std::vector<BeamInputPoint> points;
        for (std::size_t at = 0; at < bytes.size(); at += piece)
            reader.take(std::string_view(bytes).substr(at, piece), points);
        reader.finish(points);
        REQUIRE(points == expected);
        CHECK(reader.bad_count() == 1);
    }
}

TEST_CASE("a line may end with a colour, and channels of raw points can be reassigned") {
    CHECK(read_text("0.5 0.25 1 0.01 0.2 0.4 0.8", 5) ==
          std::vector<BeamInputPoint>{{0.5f, 0.25f, 1.0f, 0.01, BeamTint{0.2f, 0.4f, 0.8f}}});
    std::string bytes;
    for (const float value : {0.1f, 0.2f, 0.3f, 0.4f, 0.5f})
        append_float(bytes, value);
    const auto read_raw = [&](const ChannelMap& map) {
        BeamInputReader reader({.is_raw = true, .channels = 5, .map = map, .seconds = 0.01},
                               "stdin");
        std::vector<BeamInputPoint> points;
        reader.take(bytes, points);
        REQUIRE(points.size() == 1);
        return points.front();
    };
    CHECK(read_raw({.x = 5, .y = 4, .r = 3, .g = 2, .b = 1}) ==
          BeamInputPoint{0.5f, 0.4f, 1.0f, 0.01, BeamTint{0.3f, 0.2f, 0.1f}});
    // Missing channels: full current, and a dark colour if another colour has a channel.
    CHECK(read_raw({.x = 1, .y = 0, .intensity = 9, .r = 2, .b = 6}) ==
          BeamInputPoint{0.1f, 0.0f, 1.0f, 0.01, BeamTint{0.2f, 0.0f, 0.0f}});
    CHECK_FALSE(read_raw({.r = 6, .g = 7}).tint.has_value());
}

TEST_CASE("a segment has the colour of its end point, and a beam without colours has no tints") {
    BeamInput sent(BeamInput::Pace::waiting);
    const std::vector<BeamInputPoint> points{{0.0f, 0.0f, 1.0f, 0.001, BeamTint{1.0f, 0.0f, 0.5f}},
                                             {1.0f, 0.0f, 1.0f, 0.001}};
    sent.append(points);
    sent.end();
    Beam beam(1, BeamPoint{});
    sent.trace({0.0, 0.01}, beam);
    REQUIRE(beam.tints.size() == beam.size());
    CHECK(beam.tints[1] == BeamTint{1.0f, 0.0f, 0.5f});
    CHECK(beam.tints.back() == BeamTint{});
    BeamInput white(BeamInput::Pace::waiting);
    white.append(std::span(points).last(1));
    white.end();
    Beam plain;
    white.trace({0.0, 0.01}, plain);
    CHECK(plain.size() > 100);
    CHECK(plain.tints.empty());
}

TEST_CASE("the light of a segment is uniform in time and split over frames without overlap") {
    BeamInput sent(BeamInput::Pace::waiting);
    const std::vector<BeamInputPoint> points{{0.0f, 0.0f, 0.0f, 0.01}, {1.0f, 0.5f, 0.5f, 0.1}};
    sent.append(points);
    sent.end();
    Beam beam;
    for (int frame = 1; frame <= 12; ++frame)
        sent.trace(frame_span(frame, 60.0), beam);
    // 1 is full current for 1/(4096 * 60) s.
    CHECK(std::abs(charge_of(beam) - 0.5 * 0.1 * 245760.0) < 0.5);
    CHECK(beam.back().x == 1.0f);
    CHECK(beam.back().y == 0.5f);
    Beam half;
    sent.trace({0.01, 0.06}, half);
    CHECK(std::abs(half.back().x - 0.5f) < 1e-4f);
    Beam after;
    sent.trace({0.2, 0.3}, after);
    CHECK(after.empty());
}

TEST_CASE("late points are drawn when they arrive") {
    BeamInput sent(BeamInput::Pace::live);
    Beam beam;
    sent.trace({0.0, 5.0}, beam);
    CHECK(beam.empty());
    const std::vector<BeamInputPoint> points{{0.25f, 0.5f, 1.0f, 0.001}};
    sent.append(points);
    sent.trace({5.0, 5.1}, beam);
    CHECK(std::abs(charge_of(beam) - 245.76) < 0.01);
    CHECK(beam.back().x == 0.25f);
}
