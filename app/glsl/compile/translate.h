#pragma once

#include "model/look/look.h"
#include "model/look/shader_limits.h"

#include <optional>
#include <string>
#include <vector>

/// A number that Vulkan shaders read from a uniform block or push constants.
struct BlockMember {
    std::string name;                // in the author's shader
    std::string uniform;             // in the translated program
    std::optional<NumberType> type;  // nullopt: an array or a struct
};

/// A texture that Vulkan shaders read.
struct NamedSampler {
    std::string name;
    std::string uniform;
};

/// Vulkan shaders translated to GLSL 4.10 with plain uniforms.
struct Translation {
    Stage vertex;
    Stage fragment;
    std::vector<BlockMember> members;    // read by some code; names may repeat
    std::vector<NamedSampler> samplers;  // read by some code
    Diagnostics warnings;
};

/// Translates via SPIR-V. The stages are matched by location, independent of names. Outputs of the
/// vertex stage take their interpolation from the fragment stage. Driver messages about the
/// translated text are mapped to the author's lines. Errors: glslang's, at the author's file and
/// line; features not allowed in libretro passes (storage, separate samplers, several blocks of a
/// kind); exceeded limits.
Result<Translation> translate_from_vulkan(const Stage& vertex, const Stage& fragment,
                                          const ShaderLimits& limits = {});
