#pragma once

#include "base/diagnostic.h"
#include "graph/tripwire.h"
#include "model/look.h"

/// A warning at the pass's line of look.json: "pass 'sum' wrote NaN/Inf at pixel (3, 4), frame
/// 12".
Diagnostic diagnostic_of(const Trip& trip, const Look& look);
