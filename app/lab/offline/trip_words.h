#pragma once

#include "base/diagnostic.h"
#include "graph/inspect/tripwire.h"
#include "model/look/look.h"

/// A warning at the pass's line of look.json: "pass 'sum' wrote NaN/Inf at pixel (3, 4), frame 12".
Diagnostic diagnostic_of(const Trip& trip, const Look& look);
