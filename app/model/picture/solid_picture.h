#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

/// Where a texel of a cube's face is seen from its middle, not normalised: GL's table of faces, s
/// and t from 0 to 1.
struct Direction {
    double x;
    double y;
    double z;
};
Direction cube_direction(int face, double s, double t);

/// A flat picture as the cube or volume that it is a drawing of, told by its shape. A cube: six
/// squares beside or below each other in GL's order, a cross of 4 x 3 or 3 x 4 squares round +z, or
/// a panorama twice as wide as high (longitude and latitude, +z in its middle, sampled bilinearly).
/// A volume: as many square slices beside or below each other as one is wide. A single pixel fills
/// either. Says what is wanted where it is none of them.
Result<Picture> solid_of(const Picture& flat, PictureShape wanted);
