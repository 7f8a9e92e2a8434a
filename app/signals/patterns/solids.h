#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <string_view>

/// A cube or volume that the program makes itself: "sky" (a cube: a horizon, clouds and a sun, 128
/// px a side), "grey-volume" or "noise-volume" (chance in 32 x 32 x 32, the same in all channels or
/// each by itself). Display-encoded.
Result<Picture> make_solid(std::string_view name);
