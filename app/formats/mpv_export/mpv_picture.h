#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <string>

/// A picture of a look in a TEXTURE block.
struct MpvPicture {
    Extent extent;
    std::string lines;  // SIZE, FORMAT and the texels in hexadecimal, after the line TEXTURE
};

/// The texels as the look's shaders read them: rows, encoding and format. Errors: the picture can't
/// be read, or has more than 4 million texels.
Result<MpvPicture> mpv_picture(const Look& look, const Image& image);
