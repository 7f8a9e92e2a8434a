#pragma once

#include "model/look/parameter.h"

#include <optional>

/// Where a value lies between the ends of a slider, 0 low .. 1 high, and back. A logarithmic slider
/// whose low end is not above zero follows a cubic instead, which also gives small values the most
/// room.
double place_in(const Range& range, Scale scale, double value);
double value_at(const Range& range, Scale scale, double place);

/// The nearest number within `range` that reads well: there are about a thousand of them over a
/// slider (a logarithmic one: as many of each size), `coarseness` times fewer.
double readable(const Range& range, Scale scale, double value, double coarseness = 1.0);

/// The values that a slider with steps stops at.
struct Steps {
    double first = 0.0;
    double step = 1.0;
    double count = 1.0;  // whole, at least 1

    double value(double index) const { return first + index * step; }
    double nearest(double value) const;
};

/// Those within `range`, counted from `origin`: "@range 3 25 2" stops at odd numbers, also after
/// a person has moved its ends. None where there is no step, or no stop within.
std::optional<Steps> steps_in(const Range& range, double origin);

/// The step that the parameter is turned by, 0 for any value; whole numbers have one of 1 at least.
double step_of(const Parameter& parameter);

/// Whether each number of a vector is turned on its own, by a slider on a line of its own.
bool has_parts(const Parameter& parameter);
