#pragma once

#include "formats/shadertoy/toy.h"

/// The passes, images and chosen pictures of a look that draws the shader, without what
/// find_parameters adds. Buffers are drawn in the order A, B, C, D, Cube A, then the Image; what
/// has not been drawn yet in a frame is read as of the frame before. `folder` is where pictures
/// that it names are looked for. Errors: there is no Image. `warnings` gets, by name, each input
/// and pass that cannot be had here.
Result<Look> look_of_toy(const Toy& toy, const std::filesystem::path& folder,
                         Diagnostics& warnings);
