#pragma once

#include "base/diagnostic.h"
#include "signals/drawing/scene.h"

#include <string_view>

/// A scene's JSON, see docs/scenes.md. SVG, OBJ and pictures that it names are read from beside it.
/// Errors have the file and line of whichever file is wrong. load_scene() also reads an OBJ, as a
/// scene of its wireframe alone.
Result<BeamScene> parse_scene(std::string_view text, const std::filesystem::path& file);
Result<BeamScene> load_scene(const std::filesystem::path& file);

/// Whether a file says of itself that it is a scene, or its name that it is an OBJ.
bool is_scene_file(const std::filesystem::path& file);
/// Whether a file's name says that it is a drawing.
bool is_svg_file(const std::filesystem::path& file);
/// Whether it says that it is a drawing or a scene.
bool is_drawn_file(const std::filesystem::path& file);
