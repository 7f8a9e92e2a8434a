#pragma once

#include "base/diagnostic.h"
#include "signals/drawing/scene.h"

#include <filesystem>
#include <string_view>
#include <vector>

/// Parses a scene's JSON, see docs/scenes.md. Reads SVG, OBJ and picture files from the same
/// folder. Errors have the file and line of the file concerned. load_scene() also loads an OBJ, as
/// a scene of its wireframe.
Result<BeamScene> parse_scene(std::string_view text, const std::filesystem::path& file);
Result<BeamScene> load_scene(const std::filesystem::path& file);

/// The files that the items of a scene name, relative to its folder. None for an OBJ or a scene
/// with errors. Names that lead outside the folder are left out.
std::vector<std::filesystem::path> files_of_scene(const std::filesystem::path& scene);

/// Whether the content of a file declares a scene, or its name an OBJ.
bool is_scene_file(const std::filesystem::path& file);
/// Whether a file is a drawing, by its name.
bool is_svg_file(const std::filesystem::path& file);
/// Whether a file is a drawing or a scene.
bool is_drawing_or_scene(const std::filesystem::path& file);
