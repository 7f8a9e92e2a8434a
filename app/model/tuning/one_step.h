#pragma once

#include "model/look/parameter.h"

/// The value one step further along its control, `up` or down. A step is that of the range,
/// otherwise a hundredth of the slider. For integers it is 1, for a list the next item, for a
/// switch the other state. `component` selects a number of a vector. A colour changes its
/// brightness by a tenth of a stop; a point moves vertically. Fails at the end of the slider, and
/// for values without steps. Messages start with the parameter's label.
Result<Value> one_step(const Parameter& parameter, const Value& value, std::size_t component,
                       bool up);
