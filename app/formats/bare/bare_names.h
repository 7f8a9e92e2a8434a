#pragma once

#include "model/look.h"

#include <string_view>
#include <vector>

/// The uniforms by which other programs tell a fragment shader time, sizes and the mouse; the first
/// of equal names counts.
const std::vector<BuiltInUniform>& bare_built_ins();

/// Whether a sampler of that name is the picture that the shader works on.
bool is_bare_source(std::string_view sampler);

/// The picture that stands for an unset sampler of that name, as Image::made.
const char* bare_stand_in(std::string_view sampler);
