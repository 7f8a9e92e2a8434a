#include "lab/document/parameter_edits.h"

#include <fmt/format.h>

#include <random>

bool is_changed(const Document& document, const Parameter& parameter) {
    return document.value(parameter) != parameter.initial;
}

const Modulation* modulation_of(const Document& document, const Parameter& parameter) {
    const auto current = name_in_state(document, parameter.name);
    const Modulations& all = document.state().modulations;
    const auto found = current ? all.find(*current) : all.end();
    return found == all.end() ? nullptr : &found->second;
}

void set_values(Document& document, const Values& values, const std::string& step_name,
                bool continues_step) {
    DocumentState next = document.state();
    for (const auto& [name, value] : values)
        if (const Parameter* parameter = find_parameter(document.look(), name))
            if (const auto current = name_in_state(document, name))
                next.values[*current] = clamped(*parameter, value);
    document.change(std::move(next), step_name, continues_step);
}

void set_modulation(Document& document, const std::string& name,
                    const std::optional<Modulation>& modulation, bool continues_step) {
    const Parameter* parameter = find_parameter(document.look(), name);
    const auto current = name_in_state(document, name);
    if (!parameter || !current)
        return;
    DocumentState next = document.state();
    if (modulation && why_unmodulated(document.look(), *parameter).empty())
        next.modulations[*current] = normalised(*modulation);
    else
        next.modulations.erase(*current);
    document.change(std::move(next), fmt::format("Modulation of {}", parameter->label),
                    continues_step);
}

void set_orbit(Document& document, const std::function<Orbit(const Orbit&)>& change) {
    DocumentState next = document.state();
    next.values = with_orbits_changed(document.look(), std::move(next.values), change);
    document.change(std::move(next), "View", true);
}

namespace {
DocumentState without_values(const Document& document, const std::vector<std::string>& names) {
    DocumentState next = document.state();
    for (const std::string& name : names)
        if (const auto current = name_in_state(document, name))
            next.values.erase(*current);
    return next;
}
}  // namespace

void reset_parameters(Document& document, const std::vector<std::string>& names) {
    const Parameter* only =
        names.size() == 1 ? find_parameter(document.look(), names.front()) : nullptr;
    document.change(without_values(document, names),
                    only ? fmt::format("Reset {}", only->label) : "Reset group");
}

void reset_group(Document& document, const std::vector<std::string>& names) {
    document.change(with_locked_parameters(without_values(document, names), document),
                    "Reset group");
}

void reset_all_parameters(Document& document) {
    DocumentState next = document.state();
    next.values.clear();
    next.modulations.clear();
    document.change(with_locked_parameters(std::move(next), document), "Reset all");
}

void randomise_parameters(Document& document, const RandomChange& change) {
    if (document.has_pending_stack())
        return;  // the names are about to change
    DocumentState next = document.state();
    next.values =
        randomised_values(document.look(), next.values, document.parameter_settings(), change);
    document.change(std::move(next), "Randomise");
}

std::uint64_t random_seed() {
    std::random_device chance;
    return (static_cast<std::uint64_t>(chance()) << 32) | chance();
}

void set_parameter_setting(Document& document, const std::string& name,
                           const ParameterSetting& setting) {
    ParameterSettings settings = document.parameter_settings();
    if (setting.is_empty())
        settings.erase(name);
    else
        settings[name] = setting;
    document.set_parameter_settings(std::move(settings));
}

namespace {
// Copies the entry, or removes it if it is missing.
template <class T>
void keep(const std::map<std::string, T>& current, const std::string& here,
          std::map<std::string, T>& next, const std::string& there) {
    if (const auto found_entry = current.find(here); found_entry != current.end())
        next[there] = found_entry->second;
    else
        next.erase(there);
}
}  // namespace

DocumentState with_locked_parameters(DocumentState next, const Document& document) {
    for (const auto& [name, setting] : document.parameter_settings()) {
        const auto here = name_in_state(document, name);
        const auto there = moved_name(name, document.look().stack, next.stack);
        if (!setting.is_locked || !here || !there)
            continue;
        keep(document.state().values, *here, next.values, *there);
        keep(document.state().modulations, *here, next.modulations, *there);
    }
    return next;
}
