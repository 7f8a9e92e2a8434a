#pragma once

#include "formats/json/object_reader.h"
#include "model/look/look.h"

#include <cstddef>

/// Reads the "inputs" of look.passes[pass]. All passes and images must be known. Errors: an input
/// that does not exist, a later pass of the same frame, a filter or mipmaps for an integer format.
void read_inputs(ObjectReader& reader, Look& look, std::size_t pass);
