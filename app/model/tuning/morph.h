#pragma once

#include "model/look/look.h"

/// Interpolates between two sets of a look's values, at `share` 0 .. 1. Numbers are linear, on
/// logarithmic sliders in equal ratios; colours are linear light. Angles with a full circle take
/// the shorter way. Integers, lists, switches and files change at 0.5.
Values morphed(const Look& look, const Values& from, const Values& to, double share);
/// The same for one parameter.
Value morphed_value(const Parameter& parameter, const Value& from, const Value& to, double share);
