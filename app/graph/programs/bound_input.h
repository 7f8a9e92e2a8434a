#pragma once

#include "gpu/program.h"
#include "model/look/look.h"

#include <optional>
#include <string>
#include <vector>

/// A texture unit of a pass and the input that is bound to it.
struct BoundInput {
    std::string uniform;
    int unit = 0;
    gpu::Uniform::Sampled sampled = gpu::Uniform::Sampled::floating;
    std::optional<Input::From> from;  // nullopt: not connected
    int pass = -1;                    // From::pass
    std::string image;                // From::image: of the look, or the parameter that selects it
    SoundTexture sound;               // From::sound
    int frames_ago = 0;
    Sampler sampler;
};

/// The source of an input of the pass, without its texture unit.
BoundInput bound_input(const Look& look, int pass, const Input& input);

/// Assigns a texture unit to each sampler of the program and finds its source: an input, otherwise
/// an image parameter.
std::vector<BoundInput> bind_inputs(const Look& look, int pass, const gpu::Program& program);
