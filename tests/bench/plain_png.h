#pragma once

#include "model/look/extent.h"

#include <cstdint>
#include <span>
#include <vector>

namespace bench {

/// The bytes of an 8-bit RGB PNG as a plain program has libpng make them of a picture that was
/// read, RGBA with row 0 at the bottom: deflate's first level, the difference to the pixel on the
/// left. Ends the program where libpng fails.
std::vector<std::uint8_t> plain_png(Extent extent, std::span<const std::uint8_t> rgba);

}  // namespace bench
