#pragma once

#include "lab/document/document.h"
#include "model/look/orbit.h"
#include "model/tuning/randomised.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

// Edits of several parameters, and of what belongs to a parameter. Locked parameters change only by
// edits that name them.

bool is_changed(const Document& document, const Parameter& parameter);
/// Null: not modulated.
const Modulation* modulation_of(const Document& document, const Parameter& parameter);

/// Sets several parameters as one undo step.
void set_values(Document& document, const Values& values, const std::string& step_name,
                bool continues_step = false);
/// Sets or removes the modulation of a parameter; its value is unchanged. A parameter that cannot
/// be modulated gets no modulation.
void set_modulation(Document& document, const std::string& name,
                    const std::optional<Modulation>& modulation, bool continues_step = false);
/// Changes the orbit parameters; all calls up to finish() are one undo step.
void set_orbit(Document& document, const std::function<Orbit(const Orbit&)>& change);
void reset_parameters(Document& document, const std::vector<std::string>& names);
/// Resets the unlocked ones of these parameters.
void reset_group(Document& document, const std::vector<std::string>& names);
/// Resets all unlocked parameters.
void reset_all_parameters(Document& document);
/// Randomises unlocked parameters within their ranges; see model/tuning/randomised.h.
void randomise_parameters(Document& document, const RandomChange& change);
/// A random seed.
std::uint64_t random_seed();
/// Without an undo step.
void set_parameter_setting(Document& document, const std::string& name,
                           const ParameterSetting& setting);

/// `next` with the current values and modulations of locked parameters.
DocumentState with_locked_parameters(DocumentState next, const Document& document);
