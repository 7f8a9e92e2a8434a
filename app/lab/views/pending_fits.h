#pragma once

#include "lab/views/views.h"
#include "model/preset/comparison.h"

#include <optional>

/// The gain in stops that maps the largest difference to white, -4 to 16. nullopt: still pending,
/// or relative, zero or infinite differences.
std::optional<double> fitting_gain(const Comparison& comparison,
                                   const std::optional<Distances>& distances);

/// Applies the requested fits when their measurement is available. Drops those without a
/// measurement. Call it after Views::update().
void apply_pending_fits(const Views& views, Lab& lab, WindowState& window);
