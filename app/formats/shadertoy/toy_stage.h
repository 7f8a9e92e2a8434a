#pragma once

#include "formats/glsl/modern_glsl.h"
#include "formats/shadertoy/toy.h"

#include <array>

/// What a channel of a pass is to its shader.
struct ToyChannel {
    PictureShape shape = PictureShape::flat;
    bool is_fed = false;  // by an input, whose size is known
};
using ToyChannels = std::array<ToyChannel, toy_channels>;

/// The fragment stage of a pass: what the site declares for it, the common code, its own, and a
/// main() that calls the author's entry. Only names that the author's code has are declared, and
/// none that it declares itself. Lines stay the author's. `common` may be null.
Stage toy_fragment_stage(const ToyPass& pass, const ToyPass* common, const ToyChannels& channels);

/// The words in the code of a pass and in what is common to all.
GlslWords toy_words(const ToyPass& pass, const ToyPass* common);

/// What the program says in the uniforms that such a stage declares. `inputs` are those of the
/// pass.
std::vector<BuiltInUniform> toy_built_ins(const std::vector<Input>& inputs, const Stage& fragment);
