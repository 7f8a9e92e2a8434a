#pragma once

#include "model/look/parameter.h"

#include <optional>

/// The position of a value on a slider, 0 low .. 1 high, and back. A logarithmic slider whose low
/// end is not above zero uses a cubic instead, which also gives small values the most room. On a
/// half-life slider, equal distances are equal ratios of half-lives within 1 ms .. 100 s.
double ratio_in(const Range& range, Scale scale, double value);
double value_at(const Range& range, Scale scale, double ratio);

/// The nearest short decimal within `range`. A slider has about a thousand of them, divided by
/// `coarseness`. A logarithmic slider has as many per magnitude, a half-life slider per magnitude
/// of 1 - value.
double readable(const Range& range, Scale scale, double value, double coarseness = 1.0);

/// The values of a slider with steps.
struct Steps {
    double first = 0.0;
    double step = 1.0;
    double count = 1.0;  // integer, at least 1

    double value(double index) const { return first + index * step; }
    double nearest(double value) const;
};

/// The steps within `range`, counted from `origin`: "@range 3 25 2" stops at odd numbers, also
/// after the user has changed its ends. nullopt without a step, or without a stop in the range.
std::optional<Steps> steps_in(const Range& range, double origin);

/// The step of the parameter, 0 for any value; at least 1 for integers.
double step_of(const Parameter& parameter);

/// Whether each component of a vector has its own slider on its own line.
bool has_parts(const Parameter& parameter);
