#include "lab/document/stack_edits.h"

#include <fmt/format.h>

void set_stack(Document& document, Stack stack, const std::string& step_name) {
    DocumentState next = document.state();
    next.values = moved(next.values, next.stack, stack);
    next.overrides = moved(next.overrides, next.stack, stack);
    next.modulations = moved(next.modulations, next.stack, stack);
    const bool has_picture = is_picture_driven(stack);
    next.stack = with_picture_driven(std::move(stack), has_picture);
    document.change(std::move(next), step_name);
}

void set_override(Document& document, const std::string& pass, PassOverride override) {
    const auto current = name_in_state(document, pass);
    if (!current)
        return;
    DocumentState next = document.state();
    if (override.is_empty())
        next.overrides.erase(*current);
    else
        next.overrides[*current] = override;
    document.change(std::move(next), fmt::format("Pass {}", pass));
}

void clear_overrides(Document& document) {
    DocumentState next = document.state();
    next.overrides.clear();
    document.change(std::move(next), "Reset all passes");
}
