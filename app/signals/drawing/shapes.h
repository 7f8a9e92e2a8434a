#pragma once

#include "model/look/picture.h"
#include "signals/drawing/scene.h"

#include <array>
#include <vector>

/// Circular arc around 0,0; degrees counter-clockwise from the right.
ScenePath arc_path(double radius, double from_degrees, double to_degrees);
/// `sides` corners on a circle, the first at the top. Edges connect every `skip`-th corner (2: a
/// star).
std::vector<ScenePath> polygon_paths(double radius, int sides, int skip);
/// Grid lines around 0,0 for columns * rows cells.
std::vector<ScenePath> grid_paths(double width, double height, int columns, int rows);
/// A picture scanned in `lines` lines from the top, each from left to right. The current is the
/// luminance. The width follows from the height and the picture's aspect ratio.
std::vector<ScenePath> raster_paths(const Picture& picture, double height, int lines);
/// The paths centred at 0,0 and scaled to fit into a square with this side.
std::vector<ScenePath> fitted_paths(std::vector<ScenePath> paths, double side);
/// Edges between corners, joined into long paths to reduce the number of blanked moves.
std::vector<ScenePath> edge_paths(const std::vector<ScenePoint>& corners,
                                  const std::vector<std::array<std::size_t, 2>>& edges);
