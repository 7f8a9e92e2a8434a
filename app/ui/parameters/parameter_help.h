#pragma once

#include "ui/parameters/parameter_control.h"

/// Attaches to the last drawn label: help as a tooltip, and on click a popup with a link to the
/// shader.
void draw_parameter_help(const ParameterEntry& entry, const Scene& scene, Edits& edits);

/// Factor from the shader's unit to the displayed one: degrees for angles in radians.
double shown_factor(const Parameter& parameter);

/// The displayed value: with its unit, and list items by their label.
std::string short_value(const Parameter& parameter, const Value& value);

/// Warns about moiré between this period and the pixels; "": no warning.
std::string moire_warning(const ParameterEntry& entry);

void reset_parameter(const std::string& name, Edits& edits);
