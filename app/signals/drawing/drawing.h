#pragma once

#include "base/diagnostic.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Where the beam is: x and y from -1, left and bottom, to 1.
using BeamPlace = std::array<double, 2>;

/// What is drawn without lifting the pen, by the points that it goes through.
struct Stroke {
    std::vector<BeamPlace> points;
    bool is_smooth = false;  // a curve through the points, not straight lines
    bool is_closed = false;  // goes on to its first point

    bool operator==(const Stroke&) const = default;
};

/// The strokes that are seen together at one time.
using Keyframe = std::vector<Stroke>;

/// What a person drew: keyframes that turn into each other. A value.
struct Drawing {
    std::vector<Keyframe> keyframes;
    bool is_to_scale = true;  // false: of another program, whose size means nothing here

    bool operator==(const Drawing&) const = default;
};

/// More than these a hand does not draw.
constexpr std::size_t most_drawing_points = 20000;
constexpr std::size_t most_keyframes = 100;

std::size_t point_count(const Drawing& drawing);
bool has_strokes(const Drawing& drawing);

/// The drawing as one line of text without commas, as it stands in a signal's setting: a pair of
/// brackets for each keyframe, in it strokes between semicolons, each L (lines) or S (smooth), its
/// x y x y, and z where it is closed: "[L-0.5 0 0.5 0;S0 0 0.1 0.2 0.3 0z][]". Numbers have four
/// decimals.
std::string to_text(const Drawing& drawing);
/// Reads to_text's text. Errors say the keyframe and stroke, without a file.
Result<Drawing> parse_drawing(std::string_view text);

/// A drawing of another program with its longer side so long (half screens), its middle in the
/// middle; one that is to scale stays as it is.
Drawing to_scale(const Drawing& drawing, double side);

/// The number that a drawing keeps for a coordinate: a ten-thousandth of half a screen is less than
/// any screen shows.
double kept_coordinate(double value);
