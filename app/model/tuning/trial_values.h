#pragma once

#include "model/look/parameter.h"

#include <vector>

/// Other values of a parameter, for finding out whether it has an effect: one step up or down, both
/// ends of the range, all other items of a list, the other state of a switch, black and white for a
/// colour. None is `value`. Empty for a parameter without such values: an image, a sound, an event,
/// a matrix.
std::vector<Value> trial_values(const Parameter& parameter, const Value& value);
