#pragma once

#include "model/look/look.h"

#include <string>
#include <string_view>

/// Converts a fragment shader of another program to GLSL 4.10, keeping line numbers. Adds the
/// predeclared inputs and outputs of old versions and the declarations of hosts. Removes the
/// locations of inputs and uniforms, which are matched by name here. `define` is defined in it; "":
/// no define.
Stage fragment_shader_stage(const Stage& written, std::string_view define = {});
