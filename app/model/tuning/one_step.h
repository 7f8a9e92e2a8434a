#pragma once

#include "model/look/parameter.h"

/// The value one step further along its control, `up` or down. A step is that of the range, else a
/// hundredth of the slider's length; 1 for whole numbers, the next item of a list, the other state
/// of a switch. `component` says which number of a vector; a colour becomes a tenth of a stop
/// brighter or darker as a whole, a point goes up or down. Fails where there is none: at the
/// slider's end, and for what has no steps; the message goes on after the parameter's name.
Result<Value> one_step(const Parameter& parameter, const Value& value, std::size_t component,
                       bool up);
