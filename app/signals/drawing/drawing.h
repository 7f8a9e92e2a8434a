#pragma once

#include "base/diagnostic.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Position of the beam: x and y from -1 (left, bottom) to 1.
using BeamPosition = std::array<double, 2>;

/// One continuous line through its points.
struct Stroke {
    std::vector<BeamPosition> points;
    bool is_smooth = false;  // a curve through the points instead of straight lines
    bool is_closed = false;  // ends at its first point

    bool operator==(const Stroke&) const = default;
};

/// The strokes visible at the same time.
using Keyframe = std::vector<Stroke>;

/// A drawing by the user: keyframes that morph into each other. A value.
struct Drawing {
    std::vector<Keyframe> keyframes;
    bool is_to_scale = true;  // false: imported, with a size in other units

    bool operator==(const Drawing&) const = default;
};

/// Limits of a drawing by hand.
constexpr std::size_t max_drawing_points = 20000;
constexpr std::size_t max_keyframes = 100;

std::size_t point_count(const Drawing& drawing);
bool has_strokes(const Drawing& drawing);

/// The drawing as one line of text without commas, for the setting of a signal. Each keyframe is in
/// brackets, with strokes separated by semicolons. A stroke is L (lines) or S (smooth), its x y x
/// y, and z when closed. Example: "[L-0.5 0 0.5 0;S0 0 0.1 0.2 0.3 0z][]". Numbers have four
/// decimals.
std::string to_text(const Drawing& drawing);
/// Parses the text of to_text(). Errors name the keyframe and stroke, without a file.
Result<Drawing> parse_drawing(std::string_view text);

/// Scales an imported drawing so that its longer side is `side` half screens, and centres it. A
/// drawing that is to scale is unchanged.
Drawing to_scale(const Drawing& drawing, double side);

/// A coordinate rounded as in a drawing: 1/10000 of half a screen, finer than the resolution of any
/// screen.
double kept_coordinate(double value);
