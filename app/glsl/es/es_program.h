#pragma once

#include "glsl/es/es_constants.h"
#include "model/look/input.h"
#include "model/look/look.h"

#include <map>
#include <string>

/// The shaders of a pass in GLSL ES 3.00, which WebGL 2 compiles. Uniforms, inputs and outputs have
/// the names of the GLSL 4.10 texts.
struct EsProgram {
    std::string vertex;
    std::string fragment;
};

/// Translates the shaders of a pass, which check_program() has accepted. `samplers`: see
/// es_source(). `constants` become macros SPIRV_CROSS_CONSTANT_ID_n, unless they are defined
/// before. Errors name the feature that GLSL ES 3.00 lacks, at the author's file.
Result<EsProgram> translate_to_es(const Stage& vertex, const Stage& fragment,
                                  const std::map<std::string, Sampler>& samplers,
                                  const std::vector<EsConstant>& constants = {});
