#pragma once

#include "signals/patterns/pattern.h"

/// What shaders read for chance and grain: independent noise, grey noise, a stone that tiles, and
/// Bayer's matrix.
std::vector<Pattern> noise_patterns();
