#pragma once

#include "base/diagnostic.h"
#include "signals/drawing/scene.h"

#include <string_view>

/// The edges of a Wavefront OBJ (`v`, `f`, `l`; all else is passed over), each drawn once. y stays
/// up and z stays towards the eye. Errors have `file` and the line.
Result<std::vector<ScenePath>> parse_obj(std::string_view text, const std::filesystem::path& file);
Result<std::vector<ScenePath>> load_obj(const std::filesystem::path& file);
