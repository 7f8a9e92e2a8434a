#pragma once

#include "model/parameter.h"

/// A value in a person's words, without its unit: a list's item by its label, "on", degrees, a
/// colour as #rrggbb of sRGB where it has such, a file by its name; numbers to `digits` significant
/// digits.
std::string value_text(const Parameter& parameter, const Value& value, int digits = 4);

/// The unit behind such a text: "px", "°"; "" for none.
std::string unit_text(const Parameter& parameter);
