#pragma once

#include "glsl/limits/bounds.h"
#include "model/look/shader_limits.h"

#include <string>

/// Finds a struct with too many members, structs nested too deeply, or a switch with too many
/// cases, with macros expanded. Members of members count as well; an array counts as one. glslang
/// visits each of them for every use: 30 structs that each hold two of the previous one have 10^9
/// members. It compares each case with all others.
std::optional<LimitViolation> find_large_declaration(const std::string& text,
                                                     const ShaderLimits& limits);
