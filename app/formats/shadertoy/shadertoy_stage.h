#pragma once

#include "formats/glsl/modern_glsl.h"
#include "formats/shadertoy/shadertoy.h"

#include <array>

/// Properties of a channel in the shader.
struct ShadertoyChannel {
    PictureShape shape = PictureShape::flat;
    bool is_connected = false;  // has an input, with a known size
};
using ShadertoyChannels = std::array<ShadertoyChannel, shadertoy_channels>;

/// The fragment stage of a pass: the site's declarations, the common code, the pass's code, and a
/// main() that calls the author's entry point. Declares only names that the author's code uses and
/// does not declare. Keeps the author's line numbers. `common` may be null.
Stage shadertoy_fragment_stage(const ShadertoyPass& pass, const ShadertoyPass* common,
                               const ShadertoyChannels& channels);

/// Adds "did you mean 'iTime'?" to errors about undeclared names that are similar to an input of
/// the site. A stage declares only the inputs that it uses, so the compiler does not know the
/// others.
void suggest_shadertoy_inputs(Diagnostics& problems);

/// The words in the code of a pass and in the common code.
GlslWords shadertoy_words(const ShadertoyPass& pass, const ShadertoyPass* common);

/// The built-in uniforms that such a stage declares. `inputs` are those of the pass.
std::vector<BuiltInUniform> shadertoy_built_ins(const std::vector<Input>& inputs,
                                                const Stage& fragment);
