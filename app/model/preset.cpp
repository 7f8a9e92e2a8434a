#include "model/preset.h"

#include <fmt/format.h>

Diagnostics compare_with_look(const Preset& preset, const Look& look,
                              const std::filesystem::path& file) {
    Diagnostics notes;
    const auto note = [&](std::string message) {
        notes.push_back({file, 0, std::move(message), Severity::warning});
    };
    for (const std::string& name : orphans(look, preset.values))
        note(fmt::format("'{}' has no parameter '{}' any more; its value {} is kept{}", look.name,
                         name, to_string(preset.values.at(name)),
                         did_you_mean(name, parameter_names(look))));
    for (const auto& [name, modulation] : preset.modulations)
        if (!find_parameter(look, name) && !preset.values.contains(name))
            note(fmt::format("'{}' has no parameter '{}' any more; its modulation is kept{}",
                             look.name, name, did_you_mean(name, parameter_names(look))));
    if (notes.empty() && !preset.digest.empty() && !covers_digest(look, preset.digest))
        note(
            fmt::format("'{}' has other defaults, or fewer parameters, than when this preset was "
                        "saved",
                        look.name));
    return notes;
}
