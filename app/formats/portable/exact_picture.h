#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <string>

/// A generated picture, and a file with its values.
struct PictureFile {
    std::string extension;  // ".png"
    std::string bytes;
    Picture picture;
};

/// The smallest file that has a picture's values: PNG with 8 bits if it has no others, else with 16
/// bits, or EXR with 16-bit floats for linear light.
Result<PictureFile> exact_picture_file(const Picture& picture);
