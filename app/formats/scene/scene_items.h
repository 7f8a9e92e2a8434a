#pragma once

#include "formats/json/object_reader.h"
#include "signals/drawing/scene.h"

#include <filesystem>

/// Whether a name stays in the folder of a scene.
bool is_in_scene_folder(const std::filesystem::path& name);

/// Reads one element of a scene's "items". Reports errors in the reader's problems.
SceneItem read_scene_item(ObjectReader& reader);
