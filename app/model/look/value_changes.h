#pragma once

#include "model/look/look.h"

/// The names of parameters with changed values, in alphabetical order. If few values changed, this
/// costs little more than a walk over both maps.
std::vector<std::string> changed_parameters(const Look& look, const Values& before,
                                            const Values& now);

/// Makes `held` equal to `now`; much faster than a copy if they are similar.
void follow_values(Values& held, const Values& now);
