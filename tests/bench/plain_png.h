#pragma once

#include "model/look/extent.h"

#include <cstdint>
#include <span>
#include <vector>

namespace bench {

/// The bytes of an 8-bit RGB PNG, encoded by libpng from a picture that was read back: RGBA with
/// row 0 at the bottom. Deflate level 1, filter Sub. Ends the program if libpng fails.
std::vector<std::uint8_t> plain_png(Extent extent, std::span<const std::uint8_t> rgba);

}  // namespace bench
