#pragma once

#include "base/diagnostic.h"
#include "signals/drawing/scene.h"

#include <optional>
#include <string_view>
#include <vector>

/// The numbers of an SVG list, separated by spaces and commas; nullopt for other content.
std::optional<std::vector<double>> parse_svg_numbers(std::string_view text);

/// The valid start of such a list, up to its last complete pair of numbers.
std::string_view whole_svg_pairs(std::string_view text);

/// Converts a path's `d` (SVG 1.1, chapter 8) to polylines in its own coordinates, y down. Each
/// curve is divided into `steps_per_curve` steps; 1 keeps only the end points of commands. Errors
/// have no file.
Result<std::vector<ScenePath>> parse_svg_path(std::string_view text, int steps_per_curve = 16);
