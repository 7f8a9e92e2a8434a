#pragma once

#include "model/look/picture.h"
#include "model/picture/raw_picture.h"

#include <cstdint>
#include <vector>

/// The value for an 8-bit display: display values are rounded to 1/255, linear values clamped and
/// sRGB-encoded (IEC 61966-2-1). NaN becomes black.
std::uint8_t display_byte(float value, Encoding encoding);

/// RGB, row 0 at the top; grey is repeated in all channels, alpha is dropped.
std::vector<std::uint8_t> display_bytes(const Picture& picture);
/// The same bytes as for picture_of(picture).
std::vector<std::uint8_t> display_bytes(const RawPicture& picture);

/// RGBA: the same colours, and alpha rounded to 1/255 without encoding; 255 for pictures without
/// alpha.
std::vector<std::uint8_t> display_bytes_with_alpha(const Picture& picture);
std::vector<std::uint8_t> display_bytes_with_alpha(const RawPicture& picture);

/// Whether any alpha of a picture is below 1 after rounding to 1/255.
bool is_transparent(const Picture& picture);
