#pragma once

#include "model/picture.h"
#include "model/raw_picture.h"

#include <cstdint>
#include <vector>

/// What a display of 8 bits a channel is sent: display values to the nearest 1/255, linear ones
/// clamped and sRGB-encoded (IEC 61966-2-1), NaN black.
std::uint8_t display_byte(float value, Encoding encoding);

/// RGB, row 0 on top; grey on all three channels, alpha left out.
std::vector<std::uint8_t> display_bytes(const Picture& picture);
/// The same bytes as of picture_of(picture).
std::vector<std::uint8_t> display_bytes(const RawPicture& picture);
