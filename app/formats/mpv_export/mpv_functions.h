#pragma once

#include <set>
#include <string>
#include <vector>

/// A GLSL function for the author's text.
struct MpvFunction {
    std::string name;
    std::string text;
};

/// Functions that read a texture of mpv, whose own filter is linear with the wrap `edge`, in other
/// ways: afterglow_FILTER_WRAP(sampler2D image, vec2 at).
std::vector<MpvFunction> mpv_reader_functions();

/// The functions of GLSL that read a texture, for numbers instead of samplers: afterglow_texture(),
/// afterglow_textureSize() and so on. They call afterglow_read(), afterglow_texel(),
/// afterglow_texelFetch(), afterglow_size() and afterglow_level_at().
std::vector<MpvFunction> mpv_numbered_functions();

/// Rounding to 8 bits, with the curve of sRGB or without.
std::vector<MpvFunction> mpv_rounding_functions();

/// The text of those functions that `wanted` names or that such a function calls. Each stands after
/// those that it calls.
std::string mpv_function_text(const std::vector<MpvFunction>& functions,
                              std::set<std::string> wanted);
/// Adds the functions whose names are in a text.
void add_mpv_calls(const std::vector<MpvFunction>& functions, const std::string& text,
                   std::set<std::string>& wanted);
