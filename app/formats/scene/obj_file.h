#pragma once

#include "base/diagnostic.h"
#include "signals/drawing/scene.h"

#include <string_view>

/// The edges of a Wavefront OBJ (`v`, `f`, `l`; other lines are ignored), each drawn once. y points
/// up and z towards the viewer. Errors have `file` and the line.
Result<std::vector<ScenePath>> parse_obj(std::string_view text, const std::filesystem::path& file);
Result<std::vector<ScenePath>> load_obj(const std::filesystem::path& file);
