#pragma once

#include "glsl/es/es_constants.h"
#include "model/look/look.h"

#include <string>
#include <utility>
#include <vector>

/// The shaders of a look in GLSL ES 3.00. Equal texts are stored once.
struct EsShaders {
    std::vector<std::string> texts;
    std::vector<std::pair<std::size_t, std::size_t>> passes;  // vertex and fragment, in `texts`
    /// Constant parameters that a page can change: macros SPIRV_CROSS_CONSTANT_ID_n, where n is the
    /// index of the parameter.
    std::vector<EsConstant> constants;
};

/// The number of pictures that a pass reads.
std::size_t pictures_read(const EsShaders& shaders, std::size_t pass);

/// Translates all passes. The error names the pass and the feature that GLSL ES 3.00 lacks.
Result<EsShaders> es_shaders(const Look& look);
