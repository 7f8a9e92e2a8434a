#pragma once

#include "model/look/picture.h"
#include "model/picture/raw_picture.h"

#include <cstdint>
#include <vector>

/// What a display of 8 bits a channel is sent: display values to the nearest 1/255, linear ones
/// clamped and sRGB-encoded (IEC 61966-2-1), NaN black.
std::uint8_t display_byte(float value, Encoding encoding);

/// RGB, row 0 on top; grey on all three channels, alpha left out.
std::vector<std::uint8_t> display_bytes(const Picture& picture);
/// The same bytes as of picture_of(picture).
std::vector<std::uint8_t> display_bytes(const RawPicture& picture);

/// RGBA: the same colours, and alpha to the nearest 1/255, which is no light and never encoded; 255
/// where the picture has none.
std::vector<std::uint8_t> display_bytes_with_alpha(const Picture& picture);
std::vector<std::uint8_t> display_bytes_with_alpha(const RawPicture& picture);

/// Whether a picture has alpha that is anywhere below 1, as 255 shades tell it.
bool is_transparent(const Picture& picture);
