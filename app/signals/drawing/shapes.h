#pragma once

#include "model/look/picture.h"
#include "signals/drawing/scene.h"

#include <array>
#include <vector>

/// Circular arc around 0,0; degrees counter-clockwise from the right.
ScenePath arc_path(double radius, double from_degrees, double to_degrees);
/// `sides` corners on a circle, the first on top; each way goes `skip` corners on (2: a star).
std::vector<ScenePath> polygon_paths(double radius, int sides, int skip);
/// Lines around 0,0 that make columns * rows boxes.
std::vector<ScenePath> grid_paths(double width, double height, int columns, int rows);
/// A picture scanned in `lines` lines from the top, each from left to right; the current is its
/// light. As high as said, as wide as the picture's shape makes it.
std::vector<ScenePath> raster_paths(const Picture& picture, double height, int lines);
/// The paths scaled and moved, so that their extent has its middle at 0,0 and fits into a square of
/// this side.
std::vector<ScenePath> fitted_paths(std::vector<ScenePath> paths, double side);
/// Edges between corners, joined to long ways so that the beam leaves off seldom.
std::vector<ScenePath> edge_paths(const std::vector<ScenePoint>& corners,
                                  const std::vector<std::array<std::size_t, 2>>& edges);
