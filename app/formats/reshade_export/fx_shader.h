#pragma once

#include "formats/effect/effect_uniforms.h"
#include "formats/reshade_export/fx_controls.h"
#include "formats/reshade_export/fx_textures.h"

#include <map>
#include <string>

/// What to do with a look that ReShade can't draw.
inline constexpr const char* fx_alternative = "Export it with --to web or --to slang.";

/// What the shaders of all passes share.
struct FxShared {
    const Look& look;  // reduced
    FxTextures& textures;
    const std::map<std::string, FxControl>& controls;  // by parameter
};

/// A pass of an effect as a namespace with its function.
struct FxShader {
    std::string text;
    std::string function;  // "pass_crt::draw"
};

/// Writes the shader of a pass. The error is the reason why ReShade can't draw it.
Result<FxShader> fx_shader(std::size_t pass, const EffectUniforms& uniforms, FxShared& shared);

/// The values of the program that the shaders read: sizes, time, the place in the source.
std::string fx_built_ins(const Look& look, const FxTextures& textures);
