#pragma once

#include "model/look/look.h"

#include <map>
#include <optional>
#include <string>

/// The user's settings for a parameter, apart from its value. Not part of presets.
struct ParameterSetting {
    bool is_favourite = false;
    bool is_locked = false;          // only its own control changes it
    std::optional<Limit> ends = {};  // of its slider, instead of the shader's

    bool operator==(const ParameterSetting&) const = default;
    bool is_empty() const { return *this == ParameterSetting{}; }
};

/// By parameter name; missing parameters have default settings.
using ParameterSettings = std::map<std::string, ParameterSetting>;

const ParameterSetting& setting_of(const std::string& name, const ParameterSettings& settings);

/// With current parameter names instead of previous ones (`@was`).
ParameterSettings renamed_settings(const Look& look, ParameterSettings settings);

/// The parameter with the user's ends of its slider.
Parameter with_ends(Parameter parameter, const ParameterSetting& setting);
/// The requested ends of a slider, restricted to the parameter's hard limit and rounded for
/// integers. Fails if the range would be empty.
Result<Limit> fitted_ends(const Parameter& parameter, Limit ends);
/// Whether the user can see the parameter's ends: it has a slider or a pad.
bool has_ends(const Parameter& parameter);

/// The settings of each look by its id, so that a look has the same settings alone and in a stack.
using LookParameterSettings = std::map<std::string, ParameterSettings>;

/// The settings of a stack's looks, by the parameter names in the stack.
ParameterSettings settings_in(const Stack& stack, const LookParameterSettings& looks);
/// Stores them; of two copies of a look the first takes precedence.
void store_settings(LookParameterSettings& looks, const Stack& stack,
                    const ParameterSettings& settings);
