#pragma once

#include "glsl/bounds.h"
#include "glsl/shader_limits.h"

#include <string>

/// Finds a struct with more members, or structs nested deeper, than the limits allow, with macros
/// expanded. Members of its members count as well, an array as one. glslang visits each of them
/// for every use, and 30 structs that hold two of the one before have a thousand million.
std::optional<OutOfBounds> find_large_struct(const std::string& text, const ShaderLimits& limits);
