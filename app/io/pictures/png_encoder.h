#pragma once

#include "base/diagnostic.h"
#include "model/look/picture.h"

#include <cstdint>
#include <span>
#include <string>

/// The bytes of an 8-bit RGB PNG marked as sRGB, from display_bytes(), row 0 at the top. Optimised
/// for speed: deflate level 1 on differences to the left pixel. The same pixels give the same
/// bytes; errors have no file.
Result<std::string> encode_png(Extent extent, std::span<const std::uint8_t> rgb);
Result<std::string> encode_png(const Picture& picture);

/// As 16-bit RGBA or, without `has_alpha`, RGB, from display_words().
Result<std::string> encode_png_16(Extent extent, std::span<const std::uint16_t> rgba,
                                  bool has_alpha);

/// As RGBA, from display_bytes_with_alpha().
Result<std::string> encode_png_with_alpha(Extent extent, std::span<const std::uint8_t> rgba);
