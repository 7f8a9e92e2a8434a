#pragma once

#include "base/diagnostic.h"
#include "signals/scene.h"

#include <string_view>

/// A scene's JSON, see docs/scenes.md. SVG, OBJ and pictures that it names are read from beside it.
/// Errors have the file and line of whichever file is wrong.
Result<BeamScene> parse_scene(std::string_view text, const std::filesystem::path& file);
Result<BeamScene> load_scene(const std::filesystem::path& file);

/// What a scene or drawing signal plays: a scene's JSON, or an SVG as a scene of one item.
Result<BeamScene> load_drawn_file(const std::filesystem::path& file);
/// Whether load_drawn_file reads a file of this name.
bool is_drawn_file(const std::filesystem::path& file);
