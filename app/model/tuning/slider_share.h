#pragma once

#include "model/look/parameter.h"
#include "model/tuning/parameter_settings.h"

#include <cstddef>

/// Whether a device's knob can control it: numbers, switches, lists, triggers and vector
/// components; not files, colours or matrices.
bool has_slider_numbers(const Parameter& parameter);

/// Whether it has intermediate values, so that a jump would be visible.
bool is_gradual(const Parameter& parameter);

/// A number of a parameter, and the user's ends of its slider.
struct SliderNumber {
    const Parameter& parameter;
    const ParameterSetting& setting;
    std::size_t component = 0;
};

/// The value with this number at `share` of the slider, 0 low .. 1 high, rounded to a step if it
/// has steps. Items of a list have equal parts; a switch is on from the middle.
Value value_at_share(const SliderNumber& at, Value current, double share);

/// The position on the slider, 0 .. 1; for a list the middle of its item's part.
double share_at(const SliderNumber& at, const Value& value);
