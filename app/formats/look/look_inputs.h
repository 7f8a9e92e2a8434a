#pragma once

#include "formats/json/object_reader.h"
#include "model/look/look.h"

#include <cstddef>

/// Reads the "inputs" of look.passes[pass]; all passes and images are known by then. Notes what
/// reads nothing that there is, a later pass of the same frame, or what its texels cannot give.
void read_inputs(ObjectReader& reader, Look& look, std::size_t pass);
