#pragma once

#include "model/look/input.h"

#include <map>
#include <string>

/// Prepares a preprocessed GLSL 4.10 text for translation to GLSL ES 3.00. Uniforms lose their
/// default values, which ES does not have. `samplers` are the samplers that a pass reads, by the
/// name of their uniform. Replaced by functions with the same results:
/// - reads of a sampler2D whose wrap is Wrap::border, also where a function gets it as a parameter,
/// - textureGather and textureGatherOffset of a sampler2D,
/// - bitfieldReverse, bitfieldExtract, bitfieldInsert and bitCount.
/// The border is transparent black. A linear filter fades to it within half a texel.
std::string es_source(const std::string& preprocessed,
                      const std::map<std::string, Sampler>& samplers, bool is_fragment);
