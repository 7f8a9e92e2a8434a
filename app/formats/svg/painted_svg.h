#pragma once

#include "base/diagnostic.h"
#include "signals/drawing/scene.h"

#include <string_view>

/// The outlines of all that an SVG paints, in the order of painting, y turned up: every shape,
/// text, `<use>`, nested `<svg>`, units, percent and CSS, as librsvg draws them, cut to the page
/// and to clip paths. Dashes are lines of their own. Opacity, filters, masks and pictures play no
/// part, but nothing is drawn of what is fully transparent. In the units of the viewBox, else in
/// CSS px. `bytes` may be compressed (.svgz). Other files are read only in the folder of `file`.
Result<std::vector<ScenePath>> painted_outlines(std::string_view bytes,
                                                const std::filesystem::path& file);
