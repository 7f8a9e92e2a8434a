#pragma once

#include "formats/slang/preset.h"
#include "formats/slang/shader.h"
#include "glsl/compile/translate.h"

/// A chain with all that was read of it; one shader and one translation a pass.
struct WholeChain {
    SlangPreset preset;
    std::vector<SlangShader> shaders;
    std::vector<Translation> translations;
};

/// How the passes read where the preset does not say.
struct SlangDefaults {
    Filter filter = Filter::nearest;
};

/// The passes and images of a look that draws the chain, by the rules of RetroArch's GL driver:
/// the state of a sampler belongs to what it reads; a last pass with a size of its own is stretched
/// over the picture by one pass more. Parameters drive their members in all passes. Errors: two
/// passes of one alias, a pass that reads what comes after it, formats that there are not, members
/// of another type than their name has. `warnings` gets names that mean nothing (they read black
/// or 0) and pictures that are missing.
Result<Look> look_of_chain(const WholeChain& chain, const SlangDefaults& defaults,
                           Diagnostics& warnings);
