#pragma once

#include "model/tuning/parameter_settings.h"

#include <cstdint>

/// Whether Randomise changes the parameter: it is visible and has a range, a list, a checkbox or a
/// colour. Excludes iteration counts, the orbit, matrices, triggers and files.
bool is_randomised(const Look& look, const Parameter& parameter);

/// `values` with random values for all such parameters that are not locked. Positions are uniform
/// on the slider (logarithmic: uniform ratios), at steps if it has steps. Colours are uniform in
/// sRGB; alpha is unchanged. The same seed gives the same values, independently for each parameter.
Values randomised_values(const Look& look, const Values& values, const ParameterSettings& settings,
                         std::uint64_t seed);
