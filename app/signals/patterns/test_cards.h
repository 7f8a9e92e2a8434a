#pragma once

#include "signals/patterns/pattern.h"

#include <vector>

/// Adjustment pictures for display tubes: bars, ramps, lines, dots and fields.
std::vector<Pattern> test_cards();
