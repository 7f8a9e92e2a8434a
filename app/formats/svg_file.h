#pragma once

#include "base/diagnostic.h"
#include "signals/drawing.h"
#include "signals/scene.h"

#include <string_view>

/// The outlines of an SVG's paths, lines, rectangles, circles, ellipses and polygons with their
/// transforms, y turned up. Text, clips, styles, what stands in <defs> and
/// what is not displayed are passed over. An SVG
/// without any is an error. Errors have `file` and the line of the tag.
Result<std::vector<ScenePath>> parse_svg(std::string_view text, const std::filesystem::path& file);
Result<std::vector<ScenePath>> load_svg(const std::filesystem::path& file);

/// The same as a drawing. In a file of svg_text() each group with `data-keyframe` is a keyframe,
/// and strokes are what they were; of another program all is one keyframe that is not to scale.
Result<Drawing> parse_svg_drawing(std::string_view text, const std::filesystem::path& file);
Result<Drawing> load_svg_drawing(const std::filesystem::path& file);

/// The drawing as an SVG that every program shows: its picture is -1..1, only the first keyframe is
/// displayed. Smooth strokes are the curves that the beam follows.
std::string svg_text(const Drawing& drawing);
