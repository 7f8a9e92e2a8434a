#pragma once

#include "signals/patterns/pattern.h"

/// Inputs for shaders that need randomness and grain: independent noise, grey noise, a tileable
/// stone, and the Bayer matrix.
std::vector<Pattern> noise_patterns();
