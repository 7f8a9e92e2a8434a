#pragma once

#include "base/diagnostic.h"
#include "model/picture.h"

#include <string_view>

/// A cube or volume that the program makes itself: "sky" (a cube: a horizon, clouds and a sun, 128
/// px a side), "grey-volume" or "noise-volume" (chance in 32 x 32 x 32, the same in all channels or
/// each by itself). Display-encoded.
Result<Picture> make_solid(std::string_view name);

/// Where a texel of a cube's face is seen from its middle, not normalised: GL's table of faces, s
/// and t from 0 to 1.
struct Direction {
    double x;
    double y;
    double z;
};
Direction cube_direction(int face, double s, double t);
