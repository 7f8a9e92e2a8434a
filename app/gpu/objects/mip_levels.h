#pragma once

#include "gpu/objects/texture.h"

namespace gpu {

/// Draws each smaller level of the texture from the one above it, by a linear filter between linear
/// values: the mean of 2 x 2 texels where sides are even. Asked level by level, no other context
/// waits: in one call a driver may make code for it while it keeps the textures of all that share
/// them to itself. No framebuffer is bound behind it, and switches are as they were. False, with
/// nothing drawn, where the driver cannot draw into such a texture.
bool draw_mip_levels(const Texture& texture);

}  // namespace gpu
