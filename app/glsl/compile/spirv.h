#pragma once

#include "model/look/look.h"
#include "model/look/shader_limits.h"

#include <cstdint>
#include <vector>

/// A vertex and a fragment stage as SPIR-V 1.0.
struct SpirvPair {
    std::vector<std::uint32_t> vertex;
    std::vector<std::uint32_t> fragment;
    Diagnostics warnings;
};

/// Compiles GLSL for Vulkan 1.0 (uniform blocks, push constants, locations), such as libretro
/// shaders. Errors are glslang's messages at the author's file and line, and exceeded limits. The
/// code contains the line numbers of its source.
Result<SpirvPair> compile_for_vulkan(const Stage& vertex, const Stage& fragment,
                                     const ShaderLimits& limits = {});
