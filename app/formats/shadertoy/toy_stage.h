#pragma once

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

/// What the program says in the uniforms that such a stage declares. `inputs` are those of the
/// pass.
std::vector<BuiltInUniform> toy_built_ins(const std::vector<Input>& inputs, const Stage& fragment);

/// Whether the code of a pass, or what is common to all, has a word.
bool speaks_of(const ToyPass& pass, const ToyPass* common, std::string_view word);
