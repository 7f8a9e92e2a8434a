#include "graph/programs/bound_input.h"

#include <algorithm>

namespace {
const Parameter* image_parameter(const Look& look, const Binding& wanted) {
    for (const Parameter& parameter : look.parameters)
        if (parameter.control == Control::image &&
            std::ranges::find(parameter.bindings, wanted) != parameter.bindings.end())
            return &parameter;
    return nullptr;
}

// A pass that this frame has not drawn yet is read as of the previous frame.
int usable_frames_ago(const Input& input, int reader, int read) {
    return input.frames_ago == 0 && read >= reader ? 1 : input.frames_ago;
}

void feed(BoundInput& bound, const Look& look, int reader, const Input& input) {
    bound.from = input.from;
    bound.sampler = input.sampler;
    bound.frames_ago = input.frames_ago;
    bound.image = input.name;
    bound.sound = input.sound;
    if (input.from != Input::From::pass)
        return;
    const auto read = find_pass(look, input.name);
    if (!read)
        bound.from.reset();
    bound.pass = read.value_or(-1);
    bound.frames_ago = usable_frames_ago(input, reader, bound.pass);
}
}  // namespace

BoundInput bound_input(const Look& look, int pass, const Input& input) {
    BoundInput bound;
    bound.uniform = input.uniform;
    feed(bound, look, pass, input);
    return bound;
}

std::vector<BoundInput> bind_inputs(const Look& look, int pass, const gpu::Program& program) {
    const std::vector<Input>& inputs = look.passes[static_cast<std::size_t>(pass)].inputs;
    std::vector<BoundInput> all;
    int unit = 0;
    for (const gpu::Uniform& uniform : program.uniforms()) {
        if (uniform.sampled == gpu::Uniform::Sampled::none)
            continue;
        program.set_unit(uniform, unit);
        BoundInput bound;
        bound.uniform = uniform.name;
        bound.unit = unit;
        bound.sampled = uniform.sampled;
        const auto input = std::ranges::find(inputs, uniform.name, &Input::uniform);
        if (input != inputs.end())
            feed(bound, look, pass, *input);
        else if (const Parameter* picker = image_parameter(look, {pass, uniform.name})) {
            bound.from = Input::From::image;
            bound.image = picker->name;
        }
        all.push_back(std::move(bound));
        unit += uniform.count;
    }
    return all;
}
