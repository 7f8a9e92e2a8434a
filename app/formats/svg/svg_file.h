#pragma once

#include "base/diagnostic.h"
#include "signals/drawing/drawing.h"
#include "signals/drawing/scene.h"

#include <string_view>

/// Like painted_outlines(), for a file of at most 16 MiB.
Result<std::vector<ScenePath>> load_svg(const std::filesystem::path& file);

/// An SVG as a drawing. In a file of svg_text() each group with `data-keyframe` is a keyframe, and
/// strokes are restored. For other files the painted_outlines() are one keyframe that is not to
/// scale. `bytes` may be compressed. Errors have `file` and the line of the tag.
Result<Drawing> parse_svg_drawing(std::string_view bytes, const std::filesystem::path& file);
Result<Drawing> load_svg_drawing(const std::filesystem::path& file);

/// The drawing as an SVG for any program: its picture is -1..1, and only the first keyframe is
/// displayed. Smooth strokes are the curves that the beam follows.
std::string svg_text(const Drawing& drawing);
