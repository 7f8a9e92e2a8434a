#pragma once

#include "model/look/input.h"

#include <map>
#include <string>

/// Which stage a text is, and what its translation needs.
struct EsStage {
    bool is_fragment = false;
    bool is_impure = false;  // each function writes a global variable
};

/// Prepares a preprocessed GLSL 4.10 text for translation to GLSL ES 3.00. Uniforms lose their
/// default values, which ES does not have. `samplers` are the samplers that a pass reads, by the
/// name of their uniform. Replaced by functions with the same results:
/// - reads of a flat picture whose wrap is Wrap::border, also where a function gets it,
/// - gathers and queries of levels of a sampler2D,
/// - functions of bits and of packed numbers.
/// The border is transparent black. A linear filter fades to it within half a texel.
std::string es_source(const std::string& preprocessed,
                      const std::map<std::string, Sampler>& samplers, const EsStage& stage);
