#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <cstdint>
#include <span>
#include <string>

/// The bytes of an 8-bit RGB PNG marked as sRGB, of display_bytes(), row 0 on top; made fast:
/// deflate at its first level on differences to the pixel on the left. The same pixels give the
/// same bytes; errors carry no file.
Result<std::string> encode_png(Extent extent, std::span<const std::uint8_t> rgb);
Result<std::string> encode_png(const Picture& picture);

/// The same as RGBA, of display_bytes_with_alpha().
Result<std::string> encode_png_with_alpha(Extent extent, std::span<const std::uint8_t> rgba);
