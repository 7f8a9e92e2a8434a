#pragma once

#include "model/plan/plan.h"
#include "model/tuning/modulation.h"

#include <string>

/// Everything needed to draw a look elsewhere, as JSON: passes with complete GLSL, target and
/// inputs; images; parameters with their current values.
std::string describe_json(const Look& look, const Plan& plan, const Values& values,
                          const Modulations& modulations = {});
