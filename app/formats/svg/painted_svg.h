#pragma once

#include "base/diagnostic.h"
#include "signals/drawing/scene.h"

#include <string_view>

/// The outlines of everything that an SVG paints, in painting order, with y up. Supports all
/// shapes, text, `<use>`, nested `<svg>`, units, percentages and CSS, as drawn by librsvg. Clipped
/// to the page and to clip paths. Dashes are separate lines. Ignores opacity, filters, masks and
/// pictures, but omits what is fully transparent. In units of the viewBox, otherwise in CSS px.
/// `bytes` may be compressed (.svgz). Other files are read only from the folder of `file`.
Result<std::vector<ScenePath>> painted_outlines(std::string_view bytes,
                                                const std::filesystem::path& file);
