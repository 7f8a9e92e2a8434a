#pragma once

#include "model/look/parameter.h"

#include <string_view>

/// A value for display, without its unit: a list's item as its label, "on", degrees, a file name. A
/// colour is sRGB #rrggbb if within its range; numbers have `digits` significant digits.
std::string value_text(const Parameter& parameter, const Value& value, int digits = 4);

/// Whether a parameter is the period of a pattern on the pixel grid: its unit is "px per period".
bool is_period(const Parameter& parameter);

/// The unit of a parameter for display: "px" for a period, otherwise the declared unit.
std::string_view shown_unit(const Parameter& parameter);

/// The unit after such a text: "px", "°"; "" without a unit.
std::string unit_text(const Parameter& parameter);
