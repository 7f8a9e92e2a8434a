#pragma once

#include "gpu/objects/texture.h"
#include "model/look/picture.h"
#include "model/picture/raw_picture.h"

#include <array>

namespace gpu {

/// The largest level with its stored values, row 0 at the top. One channel gives a grey picture,
/// two give RGB without blue. Waits for the GPU.
Picture read_picture(const Texture& texture);

/// As read_picture, for further processing on another thread: a copy, unconverted for 8-bit and
/// half float RGBA. Reuses the memory of `raw`.
void read_raw(const Texture& texture, RawPicture& raw);

/// The stored values of one texel, `y` from the top as in a Picture. Channels that the format lacks
/// are 0, alpha 1. Waits for the GPU.
std::array<float, 4> read_pixel(const Texture& texture, int x, int y);

}  // namespace gpu
