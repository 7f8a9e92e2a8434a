#pragma once

#include "formats/json/object_reader.h"
#include "model/look/look.h"

// Names of the model's enum values in portable.json that look.json lacks.
const Choices<BuiltIn>& built_in_names();
const Choices<Input::From>& texture_names();
const Choices<OrbitPart>& orbit_names();
const Choices<SoundTexture::Holds>& sound_names();
const Choices<RowOrder>& row_order_names();
const Choices<PictureShape>& shape_names();
