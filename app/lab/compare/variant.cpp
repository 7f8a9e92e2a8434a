#include "lab/compare/variant.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace {
bool is_article_switch(const Parameter& parameter) {
    const std::string& name = parameter.name;  // in a stack "crt/as_written"
    return name.substr(name.rfind('/') + 1) == "as_written";
}
}  // namespace

std::optional<Variant> article_variant(const Look& look, const Values& values) {
    std::vector<const Parameter*> switches;
    for (const Parameter& parameter : look.parameters)
        if (is_article_switch(parameter))
            switches.push_back(&parameter);
    if (switches.empty())
        return std::nullopt;
    const bool is_article = std::ranges::any_of(switches, [&](const Parameter* parameter) {
        return value_of(*parameter, values).number() != 0.0;
    });
    Variant variant{values, {"Original article", "Corrected", !is_article}};
    if (is_article)
        std::swap(variant.sides.other, variant.sides.current);
    for (const Parameter* parameter : switches)
        variant.values[parameter->name] = Value(is_article ? 0.0 : 1.0);
    return variant;
}

Values values_of(const Slot& slot, const Look& look) {
    Values values = renamed_values(look, slot.values);
    for (auto& [name, value] : values)
        if (const Parameter* parameter = find_parameter(look, name))
            value = clamped(*parameter, value);
    return changed_values(look, values);
}

Variant slot_variant(const Look& look, const Slot& slot, std::size_t number) {
    const std::string name = slot_name(number);
    return {values_of(slot, look),
            {slot.preset.empty() ? fmt::format("Slot {}", name)
                                 : fmt::format("{} · {}", name, slot.preset),
             "Now", true}};
}
