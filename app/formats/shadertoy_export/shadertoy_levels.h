#pragma once

#include <string>

/// The largest mip level of the picture that can be read.
constexpr int shadertoy_last_level = 10;

/// Functions that make mip levels of the picture: level_size(), last_level(), first_level(),
/// level_place() and level_texel(). `channel`: of the picture. `texel`: the function that reads a
/// texel of it.
std::string shadertoy_level_functions(int channel, const std::string& texel);

/// The same and read_level(), which reads a mip level above 0 with a linear filter. Most are in
/// Buffer A. `buffer`: its channel.
std::string shadertoy_level_reader(int channel, const std::string& texel, int buffer);

/// The entry of Buffer A.
std::string shadertoy_level_entry();
