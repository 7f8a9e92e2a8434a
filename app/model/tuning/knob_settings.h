#pragma once

#include "model/look/look.h"

#include <map>
#include <optional>
#include <string>

/// What a person keeps about a knob, apart from its value: theirs, and in no preset.
struct KnobSetting {
    bool is_favourite = false;
    bool is_locked = false;          // nothing but the hand on its control turns it
    std::optional<Limit> ends = {};  // of its slider, instead of those that the shader says

    bool operator==(const KnobSetting&) const = default;
    bool is_empty() const { return *this == KnobSetting{}; }
};

/// By parameter name; a parameter that is not in it has nothing set.
using KnobSettings = std::map<std::string, KnobSetting>;

const KnobSetting& setting_of(const std::string& name, const KnobSettings& knobs);

/// Under the names that the look's parameters have now (`@was`).
KnobSettings renamed_knobs(const Look& look, KnobSettings knobs);

/// The parameter with the ends that the person gave its slider.
Parameter with_ends(Parameter parameter, const KnobSetting& setting);
/// What is asked of a slider's ends, as the parameter allows it: within its hard limit, whole where
/// it counts. Fails where nothing would be left between them.
Result<Limit> fitted_ends(const Parameter& parameter, Limit ends);
/// Whether the parameter's ends are anything to a person: it has a slider or a pad.
bool has_ends(const Parameter& parameter);

/// The settings of every look by its id, so that a look in a stack has those that it has alone.
using LookKnobs = std::map<std::string, KnobSettings>;

/// Those of a stack's looks, by the names that parameters have in it.
KnobSettings knobs_in(const Stack& stack, const LookKnobs& looks);
/// Puts them back; of two copies of a look the first has the say.
void keep_knobs(LookKnobs& looks, const Stack& stack, const KnobSettings& knobs);
