#pragma once

#include "base/diagnostic.h"
#include "graph/inspect/nan_detector.h"
#include "model/look/look.h"

/// A warning at the pass's line of look.json: "pass 'sum' wrote NaN/Inf at pixel (3, 4), frame 12".
Diagnostic diagnostic_of(const NonFinitePixel& trip, const Look& look);
