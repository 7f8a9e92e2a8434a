#pragma once

#include "model/look/look.h"

/// Reports a stage without a #version for an OpenGL core profile, with a suggestion.
Diagnostics check_version(const Stage& stage);

/// The text for glslang. Arrays of arrays need GLSL 4.30 there, which does not know their
/// extension for GLSL 4.10.
std::string with_nested_arrays(std::string text);
