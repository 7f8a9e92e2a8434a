#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

/// The direction from a cube's centre to a texel of a face, not normalised: OpenGL's table of
/// faces, s and t from 0 to 1.
struct Direction {
    double x;
    double y;
    double z;
};
Direction cube_direction(int face, double s, double t);

/// Converts a flat picture to a cube or volume, by its proportions. A cube is six squares in a row
/// or column in GL's order, or a cross (4 x 3 or 3 x 4) around +z. A 2:1 panorama also gives a cube
/// (longitude and latitude, +z in the middle, sampled bilinearly). A volume is a row or column of
/// square slices, their number equal to their width. A single pixel fills either. Otherwise the
/// error lists the valid layouts.
Result<Picture> solid_of(const Picture& flat, PictureShape wanted);
