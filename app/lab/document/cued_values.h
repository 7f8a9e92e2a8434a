#pragma once

#include "lab/document/document.h"
#include "model/tuning/cue_plan.h"

/// Gives the document the values and modulations that its cues give at a position in the sound, or
/// on the clock. Not a step.
void apply_cues(Document& document, const CuePlan& plan, double position);
