#pragma once

#include "ui/parameters/parameter_control.h"

/// Behind the label that was drawn last: what the parameter is, on hover; on a click the same with
/// a way into the shader.
void draw_parameter_help(const Knob& knob, const Scene& scene, Edits& edits);

/// Angles are radians in the shader and degrees to a person.
double shown_factor(const Parameter& parameter);

/// A value as a person reads it: with its unit, a list's item by its label.
std::string short_value(const Parameter& parameter, const Value& value);

/// What a period does that pixels cannot draw evenly; "" where they can.
std::string moire_warning(const Knob& knob);

void reset_parameter(const std::string& name, Edits& edits);
