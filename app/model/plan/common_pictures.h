#pragma once

#include "model/plan/plan.h"

/// Lets passes share pictures that they need at different times of a frame, if extent, format and
/// levels are equal. Displayed passes keep their own. If later frames read a pass, only its newest
/// picture is shared, until it is swapped with the oldest. Selects the passes to draw last so that
/// memory is minimal. For terms with `draws_once`.
Plan with_common_pictures(const Look& look, Plan plan, const PlanTerms& terms);
