#pragma once

#include "model/tuning/parameter_settings.h"

#include <cstdint>
#include <string>
#include <vector>

/// What Randomise changes.
struct RandomChange {
    std::uint64_t seed = 0;
    double strength = 1.0;                // 0..1
    std::vector<std::string> names = {};  // of parameters; empty: all
};

/// Whether Randomise changes the parameter: it is visible and has a range, a list, a checkbox or a
/// colour. Excludes `@random no`, iteration counts, the orbit, matrices, triggers and files.
bool is_randomised(const Look& look, const Parameter& parameter);

/// `values` with random values for all such parameters that are not locked. Positions are uniform
/// on the slider (logarithmic: uniform ratios), at steps if it has steps. Colours are uniform in
/// sRGB; alpha is unchanged. With a strength below 1, positions and colours move by this share from
/// the current to the random value. A list or checkbox then changes with this probability. The same
/// seed gives the same values, independently for each parameter.
Values randomised_values(const Look& look, const Values& values, const ParameterSettings& settings,
                         const RandomChange& change);
