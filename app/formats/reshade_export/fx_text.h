#pragma once

#include <string>
#include <string_view>

/// A shader in ReShade's language, or the reason why it can't be written in it.
struct FxText {
    std::string text;
    std::string obstacle;  // "has arrays of structures"; "": none
};

/// Rewrites the HLSL of fragment_hlsl() for ReShade FX. Uniforms, textures, inputs of the stage and
/// its `main` are left out: an effect declares them. Reads of textures become those of samplers
/// with the name of the texture, some by the functions in fx_functions. `has_levels`: whether a
/// texture that it reads has mip levels.
FxText fx_text(const std::string& hlsl, bool has_levels);

/// The functions that such a text calls.
extern const char* const fx_functions;

/// Text in quotes. Ends of lines become spaces.
std::string fx_string(std::string_view text);
