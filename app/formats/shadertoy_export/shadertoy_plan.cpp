#include "formats/shadertoy_export/shadertoy_plan.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr std::size_t most_buffers = 4;
constexpr const char* other_target = "Export it with --to web.";

bool has_part_of_viewport(const Side& side, double factor) {
    return side.by == Side::By::viewport && side.factor == factor;
}

bool exceeds(const Side& side, int whole, int source) {
    const double length = side.by == Side::By::viewport ? side.factor * whole
                          : side.by == Side::By::source ? side.factor * source
                                                        : side.factor;
    return length > whole + 0.5;
}

// Mip levels of a texture with another filter than GL_LINEAR_MIPMAP_LINEAR.
bool has_rough_levels(const Sampler& sampler) {
    return sampler.filter == Filter::nearest ||
           sampler.between_levels.value_or(Filter::linear) == Filter::nearest;
}

// A pass that reads pictures of this frame, and is read without mip levels.
bool can_be_inlined(const Look& look, const Pass& pass) {
    for (const Pass& reader : look.passes)
        for (const Input& input : reader.inputs)
            if (input.from == Input::From::pass && input.name == pass.name &&
                (input.frames_ago > 0 || input.sampler.mipmap))
                return false;
    return !pass.inputs.empty() && std::ranges::all_of(pass.inputs, [](const Input& input) {
        return input.from == Input::From::pass && input.frames_ago == 0;
    });
}

std::string input_obstacle(const ShadertoyPlan& plan, std::size_t reader, const Input& input) {
    const bool is_source = plan.is_source(input);
    if (is_source && input.frames_ago > 0)
        return "reads the picture of the previous frame";
    if (input.from == Input::From::pass && input.sampler.mipmap && !is_source &&
        !plan.is_whole(input.name))
        return fmt::format("reads mip levels of '{}', which is smaller than the picture",
                           input.name);
    if (input.sampler.mipmap && has_rough_levels(input.sampler))
        return "reads mip levels without a smooth filter";
    const bool repeats = input.sampler.wrap == Wrap::repeat || input.sampler.wrap == Wrap::mirror;
    if (input.sampler.mipmap && repeats && is_source && plan.decodes())
        return "reads mip levels of a picture that repeats";
    if (is_source)
        return {};
    if (input.from != Input::From::pass)
        return "reads a picture file";
    const auto drawn = static_cast<std::size_t>(find_pass(plan.look, input.name).value_or(0));
    if (drawn + 1 == plan.look.passes.size())
        return "reads the last pass";
    if (input.frames_ago > 0 && reader > drawn)
        return "reads what an earlier pass drew in the previous frame";
    return {};
}
}  // namespace

bool ShadertoyPlan::is_source(const Input& input) const {
    return input.from == Input::From::source ||
           (input.from == Input::From::pass && input.name == source_pass);
}

bool ShadertoyPlan::decodes() const {
    return !source_pass.empty() && look.source_encoding == Encoding::linear;
}

const Pass& ShadertoyPlan::pass(const std::string& name) const {
    return look.passes[static_cast<std::size_t>(find_pass(look, name).value_or(0))];
}

bool ShadertoyPlan::is_whole(const std::string& name) const {
    const Pass& of = pass(name);
    return has_part_of_viewport(of.size[0], 1.0) && has_part_of_viewport(of.size[1], 1.0);
}

ShadertoyPlan shadertoy_plan(const Effect& effect, const std::string& beam) {
    ShadertoyPlan plan{effect.look, effect.source_pass};
    const std::vector<Pass>& passes = effect.look.passes;
    for (const Pass& pass : passes)
        for (const Input& input : pass.inputs)
            if (plan.is_source(input) && input.sampler.mipmap && plan.decodes())
                plan.has_levels = true;
    plan.beam = beam;
    if (!beam.empty()) {
        plan.inlined.insert(beam);
        for (std::size_t i = 0; i + 1 < passes.size() && passes.size() > most_buffers + 1; ++i)
            if (can_be_inlined(effect.look, passes[i]) && plan.inlined.size() == 1)
                plan.inlined.insert(passes[i].name);
    }
    int next = plan.has_levels || !beam.empty() ? 1 : 0;
    for (std::size_t i = 0; i + 1 < passes.size(); ++i)
        if (passes[i].name != plan.source_pass && !plan.inlined.contains(passes[i].name))
            plan.buffers[passes[i].name] = next++;
    return plan;
}

std::string shadertoy_obstacle(const ShadertoyPlan& plan, Extent size, Extent source) {
    const std::size_t count =
        plan.buffers.size() + (plan.has_levels ? 1 : 0) + (plan.beam.empty() ? 0 : 1);
    if (count > most_buffers)
        return fmt::format("the look needs {} buffers{}. Shadertoy has four and the image. {}",
                           count,
                           plan.has_levels      ? ", one for mip levels of the source"
                           : !plan.beam.empty() ? ", one for the points of the beam"
                                                : "",
                           other_target);
    for (std::size_t i = 0; i < plan.look.passes.size(); ++i) {
        const Pass& pass = plan.look.passes[i];
        if (pass.name == plan.source_pass)
            continue;
        const bool is_larger = exceeds(pass.size[0], size.width, source.width) ||
                               exceeds(pass.size[1], size.height, source.height);
        std::string found = is_larger ? "is larger than the picture" : "";
        for (std::size_t k = 0; found.empty() && k < pass.inputs.size(); ++k)
            found = input_obstacle(plan, i, pass.inputs[k]);
        if (!found.empty())
            return fmt::format("the pass '{}' {}, which Shadertoy can't do. {}", pass.name, found,
                               other_target);
    }
    return {};
}

std::string shadertoy_buffer_name(int buffer) {
    return fmt::format("Buffer {}", "ABCD"[static_cast<std::size_t>(buffer)]);
}
