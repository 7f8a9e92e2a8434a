#pragma once

#include "gpu/program.h"
#include "model/look/look.h"

#include <optional>
#include <string>
#include <vector>

/// A texture unit of a pass and what is to be bound there.
struct BoundInput {
    std::string uniform;
    int unit = 0;
    gpu::Uniform::Sampled sampled = gpu::Uniform::Sampled::floating;
    std::optional<Input::From> from;  // none: nothing feeds it
    int pass = -1;                    // From::pass
    std::string image;                // From::image: of the look, or the parameter that picks it
    SoundTexture sound;               // From::sound
    int frames_ago = 0;
    Sampler sampler;
};

/// What feeds an input of the pass, wherever it is bound.
BoundInput bound_input(const Look& look, int pass, const Input& input);

/// Gives each sampler of the pass's program a unit of its own, and finds what feeds it: an input,
/// else an image parameter.
std::vector<BoundInput> bind_inputs(const Look& look, int pass, const gpu::Program& program);
