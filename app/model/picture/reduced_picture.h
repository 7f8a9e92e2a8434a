#pragma once

#include "model/look/picture.h"

/// The picture at most `side` pixels wide and high, with the same shape: each pixel is the mean of
/// the area that it covers, in the encoding of the picture. A smaller picture is unchanged.
Picture reduced_picture(const Picture& picture, int side);
