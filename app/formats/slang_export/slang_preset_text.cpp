#include "formats/slang_export/slang_preset_text.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
const char* wrap_name_of(Wrap wrap) {
    switch (wrap) {
        case Wrap::edge:
            return "clamp_to_edge";
        case Wrap::border:
            return "clamp_to_border";
        case Wrap::repeat:
            return "repeat";
        case Wrap::mirror:
            break;
    }
    return "mirrored_repeat";
}

const char* yes_or_no(bool value) {
    return value ? "true" : "false";
}

// The sampler of the picture that a pass reads as its source: that of all its readers.
Sampler sampler_before(const Look& look, std::size_t pass) {
    for (const Pass& reader : look.passes)
        for (const Input& input : reader.inputs) {
            const bool is_same = pass == 0 ? input.from == Input::From::source
                                           : input.from == Input::From::pass &&
                                                 input.name == look.passes[pass - 1].name;
            if (is_same)
                return input.sampler;
        }
    return {};
}

// What a factor of `side` is relative to in the format. A factor of the source picture needs a
// previous pass with such a factor, or the source itself.
std::string scale_lines(const Look& look, std::size_t pass, std::size_t axis) {
    const char letter = axis == 0 ? 'x' : 'y';
    const Side& side = look.passes[pass].size[axis];
    const auto lines = [&](const char* type, double scale) {
        return fmt::format("scale_type_{0}{1} = \"{2}\"\nscale_{0}{1} = \"{3}\"\n", letter, pass,
                           type, format_number(scale));
    };
    if (side.by == Side::By::pixels)
        return lines("absolute", side.factor);
    if (side.by == Side::By::viewport)
        return lines("viewport", side.factor);
    if (pass == 0)
        return lines("source", side.factor);
    const Side& before = look.passes[pass - 1].size[axis];
    if (before.by == Side::By::source)
        return lines("source", side.factor / before.factor);
    return lines("original", side.factor);
}

std::string pass_lines(const Look& look, std::size_t pass, const std::string& shader) {
    const Sampler sampler = sampler_before(look, pass);
    std::string text = fmt::format("\nshader{0} = \"{1}\"\nalias{0} = \"{2}\"\n", pass, shader,
                                   look.passes[pass].name);
    text += fmt::format("filter_linear{0} = \"{1}\"\nwrap_mode{0} = \"{2}\"\n", pass,
                        yes_or_no(sampler.filter == Filter::linear), wrap_name_of(sampler.wrap));
    if (sampler.mipmap)
        text += fmt::format("mipmap_input{} = \"true\"\n", pass);
    if (pass + 1 < look.passes.size())
        text += scale_lines(look, pass, 0) + scale_lines(look, pass, 1);
    return text;
}
}  // namespace

std::string slang_preset_text(const Look& look, const std::vector<std::string>& shaders,
                              const std::vector<EffectPicture>& pictures) {
    std::string text = fmt::format("shaders = \"{}\"\n", look.passes.size());
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        text += pass_lines(look, i, shaders[i]);
    if (pictures.empty())
        return text;
    std::string names;
    std::string lines;
    for (const EffectPicture& picture : pictures) {
        names += (names.empty() ? "" : ";") + picture.name;
        lines += fmt::format(
            "{0} = \"{1}\"\n{0}_linear = \"{2}\"\n{0}_wrap_mode = \"{3}\"\n{0}_mipmap = \"{4}\"\n",
            picture.name, picture.path, yes_or_no(picture.sampler.filter == Filter::linear),
            wrap_name_of(picture.sampler.wrap), yes_or_no(picture.sampler.mipmap));
    }
    return text + fmt::format("\ntextures = \"{}\"\n{}", names, lines);
}

std::string slang_parameter_line(const EffectControl& control, std::size_t component,
                                 const std::string& name) {
    std::string label = control.label;
    if (control.value.numbers.size() > 1)
        label += ", " + quotable(component_label(*control.parameter, component));
    for (std::size_t i = 0; i < control.parameter->items.size(); ++i) {
        const Item& item = control.parameter->items[i];
        label += fmt::format("{}{} {}", i == 0 ? " [" : ", ", format_number(item.value),
                             quotable(item.label));
    }
    if (!control.parameter->items.empty())
        label += "]";
    return fmt::format("#pragma parameter {} \"{}\" {} {} {} {}\n", name, label,
                       format_number(control.value.numbers[component]),
                       format_number(control.range.low), format_number(control.range.high),
                       format_number(control.range.step));
}
