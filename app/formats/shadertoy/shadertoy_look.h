#pragma once

#include "formats/shadertoy/shadertoy.h"

/// The passes, images and picture parameters of a look for the shader, without the parameters of
/// find_parameters(). Buffers are drawn in the order A, B, C, D, Cube A, then Image. A pass that is
/// not drawn yet is read from the previous frame. `folder` contains the pictures. Error: the Image
/// is missing. `warnings` receives each unsupported input and pass, by name.
Result<Look> look_of_shadertoy(const Shadertoy& shadertoy, const std::filesystem::path& folder,
                               Diagnostics& warnings);
