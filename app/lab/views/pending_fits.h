#pragma once

#include "lab/views/views.h"
#include "model/preset/comparison.h"

#include <optional>

/// The gain in stops at which the largest difference shows as white, -4 to 16. None: it is not
/// measured yet, or cannot be shown that way.
std::optional<double> fitting_gain(const Comparison& comparison,
                                   const std::optional<Distances>& distances);

/// Fits what waits for a measurement that has come, and drops what nothing measures any more. To be
/// called after Views::update.
void answer_pending_fits(const Views& views, Lab& lab, WindowState& window);
