#pragma once

#include "formats/slang/preset.h"
#include "formats/slang/shader.h"
#include "glsl/compile/translate.h"

/// A chain with its loaded shaders: one shader and one translation per pass.
struct TranslatedChain {
    SlangPreset preset;
    std::vector<SlangShader> shaders;
    std::vector<Translation> translations;
};

/// Sampling of passes that the preset does not specify.
struct SlangDefaults {
    Filter filter = Filter::nearest;
};

/// The passes and images of a look for the chain, by the rules of RetroArch's GL driver. Sampler
/// states belong to the texture that is read. A last pass with its own size is stretched to the
/// picture by an additional pass. A parameter drives its members in all passes. Errors: passes with
/// the same alias, a pass that reads a later one, unknown formats, members whose type does not
/// match their name. `warnings` receives unknown names (they read black or 0) and missing pictures.
Result<Look> look_of_chain(const TranslatedChain& chain, const SlangDefaults& defaults,
                           Diagnostics& warnings);
