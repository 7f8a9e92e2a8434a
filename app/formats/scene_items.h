#pragma once

#include "formats/object_reader.h"
#include "signals/scene.h"

/// One member of a scene's "items". Mistakes are noted in the reader's problems.
SceneItem read_scene_item(ObjectReader& reader);
