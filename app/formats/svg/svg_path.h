#pragma once

#include "base/diagnostic.h"
#include "signals/drawing/scene.h"

#include <optional>
#include <string_view>
#include <vector>

/// The numbers of an SVG list, between spaces and commas; nothing when it holds anything else.
std::optional<std::vector<double>> parse_svg_numbers(std::string_view text);

/// What such a list begins with, up to its last whole pair of numbers.
std::string_view whole_svg_pairs(std::string_view text);

/// A path's `d` (SVG 1.1, chapter 8) as polylines in its own coordinates, y down. A curve
/// is cut into as many steps; with 1 only the points that the commands lead to are left. Errors say
/// what is wrong without a file.
Result<std::vector<ScenePath>> parse_svg_path(std::string_view text, int steps_a_curve = 16);
