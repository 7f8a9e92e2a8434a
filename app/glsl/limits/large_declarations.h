#pragma once

#include "glsl/limits/bounds.h"
#include "model/look/shader_limits.h"

#include <string>

/// Finds a struct with more members, structs nested deeper, or a switch with more cases than the
/// limits allow, with macros expanded. Members of its members count as well, an array as one.
/// glslang visits each of them for every use, and 30 structs that hold two of the one before have a
/// thousand million; it compares each case with all others.
std::optional<OutOfBounds> find_large_declaration(const std::string& text,
                                                  const ShaderLimits& limits);
