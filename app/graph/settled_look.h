#pragma once

#include "model/plan.h"

#include <functional>

/// The look with these values in its texts, for programs that are to draw with no others and by no
/// other plan: what these switch off is not compiled. `moves` says which parameters stay uniforms
/// all the same; events and orbits do.
Look settled_look(Look look, const Values& values, const Plan& plan,
                  const std::function<bool(const Parameter&)>& moves);
