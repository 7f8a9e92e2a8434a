#pragma once

#include "gpu/objects/texture.h"
#include "model/look/picture.h"
#include "model/picture/raw_picture.h"

#include <array>

namespace gpu {

/// The largest level as it is stored, row 0 on top. One channel gives a grey picture, two give RGB
/// without blue. Waits for the GPU.
Picture read_picture(const Texture& texture);

/// The same for another thread to go on with: a copy, without any conversion where the format has
/// half floats. Memory that `raw` has is used again.
void read_raw(const Texture& texture, RawPicture& raw);

/// The stored numbers of one texel, `y` down from the top as in a Picture; channels that the format
/// lacks are 0, alpha 1. Waits for the GPU.
std::array<float, 4> read_pixel(const Texture& texture, int x, int y);

}  // namespace gpu
