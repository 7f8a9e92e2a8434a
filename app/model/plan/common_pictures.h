#pragma once

#include "model/plan/plan.h"

/// The plan with pictures in common for passes that do not need theirs at the same time of a frame,
/// where extent, format and levels are the same: those that nobody looks at and that no later frame
/// reads, and of those that later frames read the newest one beside the oldest. Which passes are
/// drawn last is chosen so that the least memory is taken. For terms that say `draws_once`.
Plan with_common_pictures(const Look& look, Plan plan, const PlanTerms& terms);
