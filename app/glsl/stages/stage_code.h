#pragma once

#include "model/look/look.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// A shader in other languages, for programs that do not compile GLSL 4.10.
struct StageCode {
    std::string spirv;                          // SPIR-V 1.0 for Vulkan 1.0, little-endian
    std::string hlsl;                           // Shader Model 5.0
    std::string msl;                            // Metal Shading Language 2.0
    std::string reflection;                     // JSON of SPIRV-Cross: inputs, uniforms, textures
    std::map<std::string, std::string> faults;  // "spirv", "hlsl", "msl": why it is not compiled
};

/// Both shaders of a pass. Uniforms that are no samplers are members of one block, `Uniforms`, at
/// binding 0 of set 0, in the order of their declaration. Inputs and outputs have locations.
struct PassCode {
    StageCode vertex;
    StageCode fragment;
};

/// Translates the shaders of a pass, which check_program() has accepted. SPIR-V is validated, and
/// HLSL compiled with glslang; nothing here compiles MSL. The error is the reason why Vulkan can't
/// express the shader.
Result<PassCode> stage_code(const Stage& vertex, const Stage& fragment);
