#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <string_view>

/// A generated cube or volume, display-encoded. "sky": a cube with a horizon, clouds and a sun, 128
/// px a side. "grey-volume", "noise-volume": noise in 32 x 32 x 32, equal or independent channels.
Result<Picture> make_solid(std::string_view name);
