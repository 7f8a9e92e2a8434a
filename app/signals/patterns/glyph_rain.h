#pragma once

#include "signals/patterns/pattern.h"

/// Falling glyphs: heads at 1.0 with fading trails, and a bloom that raises the heads above 1.
/// Linear light, unbounded.
Pattern glyph_rain_pattern();
