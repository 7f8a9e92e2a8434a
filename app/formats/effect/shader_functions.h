#pragma once

/// Functions in GLSL that several formats add to exported shaders. Each text starts with an empty
/// line.

/// vec4 display_to_linear(vec4 display): sRGB to linear light, IEC 61966-2-1. Alpha stays.
extern const char* const decoding_function;

/// vec4 bordered(vec4 read, vec2 at, vec2 size, bool is_smooth): what is read at a place of a
/// picture (from 0 to 1) of a size (px), transparent black beyond its edges. `is_smooth`: by linear
/// filtering.
extern const char* const border_function;

/// float level_at(vec2 place): the mip level that texture() reads at a place, in texels of the
/// largest level. It is chosen as in Mesa's software renderer: both derivatives are those of one
/// pixel of the four, and the logarithm of the square is linear between powers of 2.
extern const char* const level_function;
