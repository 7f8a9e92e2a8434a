#pragma once

#include "gpu/objects/texture.h"

namespace gpu {

/// Draws each smaller level of the texture from the next larger one, with a linear filter in linear
/// light. For even sides this is the mean of 2 x 2 texels. One call per level keeps other contexts
/// from waiting. In a single call, a driver may compile code while it locks the textures of all
/// contexts that share them. Leaves no framebuffer bound; other state is unchanged. False, with
/// nothing drawn, if the driver can't render to such a texture.
bool draw_mip_levels(const Texture& texture);

}  // namespace gpu
