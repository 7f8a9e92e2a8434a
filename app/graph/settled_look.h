#pragma once

#include "model/look.h"

#include <functional>

/// The look with these values in its texts, for programs that are to draw with no others: what the
/// values switch off is not compiled. `moves` says which parameters stay uniforms all the same;
/// events and orbits do.
Look settled_look(Look look, const Values& values,
                  const std::function<bool(const Parameter&)>& moves);
