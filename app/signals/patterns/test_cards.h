#pragma once

#include "signals/patterns/pattern.h"

#include <vector>

/// What engineers put on a tube to adjust it: bars, ramps, lines, dots and fields.
std::vector<Pattern> test_cards();
