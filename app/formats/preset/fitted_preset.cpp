#include "formats/preset/fitted_preset.h"

#include "formats/preset/modulation_format.h"
#include "formats/preset/preset_format.h"

Preset fitted_preset(const Look& look, Preset preset, const std::filesystem::path& file,
                     Diagnostics& warnings) {
    const auto warn = [&warnings](const Diagnostics& problems) {
        for (Diagnostic problem : problems) {
            problem.severity = Severity::warning;
            warnings.push_back(std::move(problem));
        }
    };
    if (auto values = fitted_values(look, preset, file))
        preset.values = std::move(*values);
    else
        warn(values.error());
    if (auto modulations = fitted_modulations(look, preset, file))
        preset.modulations = std::move(*modulations);
    else
        warn(modulations.error());
    return preset;
}
