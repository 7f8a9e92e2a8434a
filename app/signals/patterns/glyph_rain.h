#pragma once

#include "signals/patterns/pattern.h"

/// Glyphs that fall down the screen: heads at 1.0 with fading trails, and a bloom that lifts the
/// heads above 1. Linear light without an upper end.
Pattern glyph_rain_pattern();
