#pragma once

#include "lab/background_work.h"
#include "lab/rate_comparison.h"

/// A comparison of frame rates beside what the window shows.
using RateCheck = BackgroundWork<RateComparison>;
