#pragma once

#include "model/picture/raw_picture.h"

#include <cstdint>
#include <string>
#include <vector>

/// The alpha of a frame that is stored with alpha.
enum class FrameAlpha {
    none,        // stored without
    own,         // the picture's, unassociated
    from_black,  // the largest of R, G and B, which are divided by it: over black it looks the same
};

/// RGBA display values with 16 bits (65535 is 1), row 0 at the top. Linear values are clamped and
/// sRGB-encoded; alpha is not encoded. `none` gives 65535 as alpha.
std::vector<std::uint16_t> display_words(const RawPicture& picture, FrameAlpha alpha);

/// The bytes of a frame for an encoder: RGB, or RGBA with alpha, of 8 or 16 bits (low byte first).
/// With 8 bits and without alpha they are display_bytes().
std::string frame_bytes(const RawPicture& picture, int bits, FrameAlpha alpha);
