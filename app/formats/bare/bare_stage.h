#pragma once

#include "model/look/look.h"

#include <string>
#include <string_view>

/// A fragment shader of another program, as it was written, as GLSL 4.10 with its lines where they
/// were: with the outputs and inputs that old versions have without declaring them, what hosts
/// declare for an author, and without the numbers of inputs and uniforms, which are told by their
/// names here. `define` is defined in it; "": nothing.
Stage bare_fragment_stage(const Stage& written, std::string_view define = {});
