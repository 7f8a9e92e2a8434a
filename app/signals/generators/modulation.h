#pragma once

#include "signals/signal/signal_kind.h"

/// A carrier whose amplitude follows a slower sine: (1 + d sin(2 pi m u)) / (1 + d) * sin(2 pi c
/// u).
SignalKind am_kind();

/// A carrier whose phase follows a slower sine: sin(2 pi c u + index sin(2 pi m u)), index in
/// radians.
SignalKind fm_kind();
