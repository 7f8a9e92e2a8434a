#pragma once

#include "base/diagnostic.h"
#include "graph/tripwire.h"
#include "model/look.h"

/// A warning at the pass's line of look.json: "pass 'sum' drew a number that is not finite: pixel
/// 3, 4 in frame 12".
Diagnostic diagnostic_of(const Trip& trip, const Look& look);
