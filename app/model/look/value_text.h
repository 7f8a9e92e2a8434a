#pragma once

#include "model/look/parameter.h"

#include <string_view>

/// A value in a person's words, without its unit: a list's item by its label, "on", degrees, a
/// colour as #rrggbb of sRGB where it has such, a file by its name; numbers to `digits` significant
/// digits.
std::string value_text(const Parameter& parameter, const Value& value, int digits = 4);

/// Whether a parameter is the period of a pattern on pixels: its unit is "px per period".
bool is_period(const Parameter& parameter);

/// The unit of a parameter as windows show it: "px" of a period, else as it is declared.
std::string_view shown_unit(const Parameter& parameter);

/// The unit behind such a text: "px", "°"; "" for none.
std::string unit_text(const Parameter& parameter);
