#include "model/preset/preset.h"

#include <fmt/format.h>

#include <algorithm>

Diagnostics compare_with_look(const Preset& preset, const Look& look,
                              const std::filesystem::path& file) {
    Diagnostics notes;
    const auto note = [&](std::string message) {
        notes.push_back({file, 0, std::move(message), Severity::warning});
    };
    for (const std::string& name : orphans(look, renamed_values(look, preset.values)))
        note(fmt::format("'{}' no longer has the parameter '{}'{}. Its value {} is kept.",
                         look.name, name, did_you_mean(name, parameter_names(look)),
                         to_string(preset.values.at(name))));
    const auto is_known = [&](const std::string& name) {
        return std::ranges::any_of(look.parameters, [&](const Parameter& parameter) {
            return parameter.name == name || parameter.was == name;
        });
    };
    for (const auto& [name, modulation] : preset.modulations)
        if (!is_known(name) && !preset.values.contains(name))
            note(fmt::format("'{}' no longer has the parameter '{}'{}. Its modulation is kept.",
                             look.name, name, did_you_mean(name, parameter_names(look))));
    if (notes.empty() && !preset.digest.empty() && !covers_digest(look, preset.digest))
        note(
            fmt::format("the parameters or defaults of '{}' have changed since this preset was "
                        "saved",
                        look.name));
    return notes;
}
