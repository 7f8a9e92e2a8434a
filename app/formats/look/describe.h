#pragma once

#include "model/plan/plan.h"
#include "model/tuning/modulation.h"

#include <string>

/// All that is needed to draw a look elsewhere, as JSON: passes with their complete GLSL, target
/// and inputs, images, and parameters with the values in force.
std::string describe_json(const Look& look, const Plan& plan, const Values& values,
                          const Modulations& modulations = {});
