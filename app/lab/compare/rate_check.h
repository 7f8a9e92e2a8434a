#pragma once

#include "lab/offline/rate_comparison.h"
#include "lab/storage/background_work.h"

/// A comparison of frame rates beside what the window shows.
using RateCheck = BackgroundWork<RateComparison>;
