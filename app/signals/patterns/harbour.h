#pragma once

#include "signals/patterns/pattern.h"

/// A harbour at dusk in 320 x 240 pixels and sixteen colours, as a game of the early nineties might
/// have shown it.
Pattern harbour_pattern();
