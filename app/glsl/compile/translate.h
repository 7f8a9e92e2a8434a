#pragma once

#include "model/look/look.h"
#include "model/look/shader_limits.h"

#include <optional>
#include <string>
#include <vector>

/// A number that shaders for Vulkan read from a uniform block or the push constants.
struct BlockMember {
    std::string name;                // as its author calls it
    std::string uniform;             // as the translated program calls it
    std::optional<NumberType> type;  // none: an array or a structure
};

/// A texture that they read.
struct NamedSampler {
    std::string name;
    std::string uniform;
};

/// Shaders for Vulkan as GLSL 4.10 with plain uniforms.
struct Translation {
    Stage vertex;
    Stage fragment;
    std::vector<BlockMember> members;  // that some code reads; one name may be there several times
    std::vector<NamedSampler> samplers;  // that some code reads
    Diagnostics warnings;
};

/// Translates by way of SPIR-V. Stages fit together by locations, whatever their names are; what
/// the vertex stage gives takes its interpolation from the fragment stage. A driver's words about
/// the translated text find the author's lines. Errors: glslang's, at the author's file and line;
/// what no picture pass of libretro may have (storage, separate samplers, several blocks of a
/// kind); limits that are exceeded.
Result<Translation> translate_from_vulkan(const Stage& vertex, const Stage& fragment,
                                          const ShaderLimits& limits = {});
