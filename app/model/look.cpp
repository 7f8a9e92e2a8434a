#include "model/look.h"

#include "base/text.h"
#include "model/renamed.h"

#include <fmt/format.h>

#include <algorithm>

std::string Input::reference() const {
    const std::string base = from == From::source     ? "source"
                             : from == From::sound    ? sound.name()
                             : from == From::keyboard ? "keyboard"
                                                      : name;
    return frames_ago > 0 ? fmt::format("{}@{}", base, frames_ago) : base;
}

bool is_of_beam(Draw draw) {
    return draw == Draw::points || draw == Draw::segments;
}

bool reads_press(const Look& look) {
    return std::ranges::any_of(look.passes, [](const Pass& pass) {
        return std::ranges::find(pass.built_ins, BuiltIn::press, &BuiltInUniform::says) !=
               pass.built_ins.end();
    });
}

bool reads_keys(const Look& look) {
    return std::ranges::any_of(look.passes, [](const Pass& pass) {
        return std::ranges::find(pass.inputs, Input::From::keyboard, &Input::from) !=
               pass.inputs.end();
    });
}

std::optional<int> find_pass(const Look& look, std::string_view name) {
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        if (look.passes[i].name == name)
            return static_cast<int>(i);
    return std::nullopt;
}

const Parameter* find_parameter(const Look& look, std::string_view name) {
    const auto found = std::find_if(look.parameters.begin(), look.parameters.end(),
                                    [&](const Parameter& p) { return p.name == name; });
    return found == look.parameters.end() ? nullptr : &*found;
}

std::string heading_of(const Look& look, const Parameter& parameter) {
    if (!parameter.group.empty() || parameter.bindings.empty())
        return parameter.group;
    return label_from_name(
        look.passes[static_cast<std::size_t>(parameter.bindings.front().pass)].name);
}

std::vector<std::string> parameter_names(const Look& look) {
    std::vector<std::string> names;
    for (const Parameter& parameter : look.parameters)
        names.push_back(parameter.name);
    return names;
}

std::vector<std::string> pass_names(const Look& look) {
    std::vector<std::string> names;
    for (const Pass& pass : look.passes)
        names.push_back(pass.name);
    return names;
}

Encoding encoding_of(const Look& look, int pass) {
    const auto index = static_cast<std::size_t>(pass);
    return index + 1 == look.passes.size() ? look.output : look.passes[index].output;
}

const Value& value_of(const Parameter& parameter, const Values& values) {
    const auto found = values.find(parameter.name);
    return found == values.end() ? parameter.initial : found->second;
}

double count_of(const Count& count, const Look& look, const Values& values) {
    if (const auto* number = std::get_if<int>(&count))
        return *number;
    const Parameter* parameter = find_parameter(look, std::get<std::string>(count));
    return parameter ? value_of(*parameter, values).number() : 0.0;
}

Values constants_of(const Look& look, const Values& values) {
    Values constants;
    for (const Parameter& parameter : look.parameters)
        if (parameter.is_constant)
            constants[parameter.name] = value_of(parameter, values);
    return constants;
}

Values changed_values(const Look& look, const Values& values) {
    Values changed = values;
    for (const Parameter& parameter : look.parameters) {
        const auto found = changed.find(parameter.name);
        if (found != changed.end() && found->second == parameter.initial)
            changed.erase(found);
    }
    return changed;
}

std::vector<std::string> orphans(const Look& look, const Values& values) {
    std::vector<std::string> names;
    // Mostly there is none, which is soon said also of a thousand values.
    const auto known = std::ranges::count_if(look.parameters, [&](const Parameter& parameter) {
        return values.contains(parameter.name);
    });
    if (static_cast<std::size_t>(known) == values.size())
        return names;
    for (const auto& [name, value] : values)
        if (!find_parameter(look, name))
            names.push_back(name);
    return names;
}

Values renamed_values(const Look& look, Values values) {
    return renamed(look, std::move(values));
}

std::string look_digest(const Look& look) {
    std::vector<std::string> lines;
    for (const Parameter& parameter : look.parameters)
        lines.push_back(parameter.name + '=' + to_string(parameter.initial) + '\n');
    std::sort(lines.begin(), lines.end());
    std::string text;
    for (const std::string& line : lines)
        text += line;
    const std::uint64_t digest = digest_of(text);
    return fmt::format("{:08x}", static_cast<std::uint32_t>(digest ^ (digest >> 32)));
}
