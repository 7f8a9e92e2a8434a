#pragma once

#include "base/diagnostic.h"
#include "model/look/look.h"

#include <string>
#include <vector>

// A condition is the expression of `@when`, such as `tube == "Custom" && blur > 0`. Names are
// parameters with a single number, of the same look. A label in quotes is compared with a list.
// Operators: == != < <= > >= && || ! and brackets.

/// Reports invalid conditions of these parameters, at the line of each parameter.
Diagnostics check_conditions(const std::vector<Parameter>& parameters);

/// Whether the parameter's condition is true for these values. True without a condition.
bool is_condition_true(const Parameter& parameter, const std::vector<Parameter>& parameters,
                       const Values& values);

/// The condition for display, with labels and items: "Tube is Custom and Blur is above 0".
std::string condition_text(const Parameter& parameter, const std::vector<Parameter>& parameters);
