#pragma once

#include "model/look/picture.h"
#include "model/picture/raw_picture.h"

/// Makes all pixels black and opaque.
void blacken(Picture& picture);
void blacken(RawPicture& raw);
