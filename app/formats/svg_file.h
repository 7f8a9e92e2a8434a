#pragma once

#include "base/diagnostic.h"
#include "signals/scene.h"

#include <string_view>

/// The outlines of an SVG's paths, lines, rectangles, circles, ellipses and polygons with their
/// transforms, y turned up. Text, clips, styles and what stands in <defs> are passed over. An SVG
/// without any is an error. Errors have `file` and the line of the tag.
Result<std::vector<ScenePath>> parse_svg(std::string_view text, const std::filesystem::path& file);
Result<std::vector<ScenePath>> load_svg(const std::filesystem::path& file);
