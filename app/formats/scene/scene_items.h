#pragma once

#include "formats/json/object_reader.h"
#include "signals/drawing/scene.h"

/// Reads one element of a scene's "items". Reports errors in the reader's problems.
SceneItem read_scene_item(ObjectReader& reader);
