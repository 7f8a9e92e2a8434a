#pragma once

#include "model/look/parameter.h"
#include "model/tuning/knob_settings.h"

#include <cstddef>

/// Whether a knob of a device can turn it: single numbers, switches, lists, triggers and the
/// numbers of vectors; no files, colours or matrices.
bool can_be_turned(const Parameter& parameter);

/// Whether it has values between its values, so that a jump would be seen as one.
bool is_gradual(const Parameter& parameter);

/// A number of a parameter, and the ends that a person gave its slider.
struct TurnedNumber {
    const Parameter& parameter;
    const KnobSetting& setting;
    std::size_t component = 0;
};

/// The value with that number so far along the slider, 0 low .. 1 high, at a step where there are
/// steps. Each item of a list has an equal part of the way; a switch is on from the middle.
Value value_at_share(const TurnedNumber& turned, Value present, double share);

/// How far along the slider it is, 0 .. 1; in a list the middle of its item's part.
double share_at(const TurnedNumber& turned, const Value& value);
