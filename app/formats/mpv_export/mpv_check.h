#pragma once

#include "base/diagnostic.h"

#include <string_view>

/// Reads a user shader as mpv does, and compiles each block with glslang as GLSL 4.40, between
/// declarations as mpv has them. Errors: unknown directives, textures that no earlier block saved,
/// more textures than mpv allows, and messages of the compiler with the name of the block.
Result<void> check_mpv_shader(std::string_view text);
