#pragma once

#include "signals/patterns/pattern.h"

/// A harbour at dusk in 320 x 240 pixels and sixteen colours, in the style of games of the early
/// 1990s.
Pattern harbour_pattern();
