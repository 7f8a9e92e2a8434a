#pragma once

#include "model/tuning/knob_settings.h"

#include <cstdint>

/// Whether a roll of the dice turns the parameter: a person sees it and turns it between two ends,
/// in a list, a box or a colour. Not what says how much is computed, the view, matrices, triggers
/// and files.
bool is_randomised(const Look& look, const Parameter& parameter);

/// `values` with every such parameter that is not locked somewhere on its slider, all places alike
/// (on a logarithmic one: all ratios), at a step where it has steps; colours evenly to the eye,
/// their alpha as it is. The same seed gives the same; what one gets does not depend on the others.
Values randomised_values(const Look& look, const Values& values, const KnobSettings& knobs,
                         std::uint64_t seed);
