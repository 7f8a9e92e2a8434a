#pragma once

#include "model/look/look.h"

/// Parameters that have another value than before, by name in the order of the alphabet. However
/// many there are, hardly more than a walk over both where few were turned.
std::vector<std::string> changed_parameters(const Look& look, const Values& before,
                                            const Values& now);

/// Makes `held` the same as `now`, which costs much less than a copy where they hardly differ.
void follow_values(Values& held, const Values& now);
