#pragma once

#include "formats/effect/effect_uniforms.h"
#include "formats/glsl/modern_glsl.h"
#include "formats/mpv_export/mpv_textures.h"

#include <string>
#include <utility>
#include <vector>

/// How a shader reads its textures in mpv.
struct MpvSampling {
    std::string declarations;
    /// Macros for the author's text: name and replacement.
    std::vector<std::pair<std::string, std::string>> macros;
};

/// Samplers with a linear filter and the wrap `edge` become macros for textures of mpv. Otherwise
/// all samplers of the pass become numbers, and functions with the names of GLSL's read them with
/// the wanted filter, wrap and mip levels. `words`: of the shader's code.
MpvSampling mpv_sampling(const EffectUniforms& uniforms, const MpvTextures& textures,
                         const GlslWords& words);
