#pragma once

#include "formats/json/object_reader.h"
#include "signals/drawing/scene.h"

/// One member of a scene's "items". Mistakes are noted in the reader's problems.
SceneItem read_scene_item(ObjectReader& reader);
