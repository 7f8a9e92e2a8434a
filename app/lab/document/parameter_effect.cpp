#include "lab/document/parameter_effect.h"

#include "model/plan/condition.h"

#include <fmt/format.h>

std::string why_without_effect(const Document& document, const Parameter& parameter,
                               std::optional<bool> probed) {
    const std::vector<Parameter>& parameters = document.look().parameters;
    if (is_condition_true(parameter, parameters, document.values()))
        return probed.value_or(true) ? "" : "No effect now. Other values draw the same picture.";
    return fmt::format("No effect now. Needs: {}.", condition_text(parameter, parameters));
}
