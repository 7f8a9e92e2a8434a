#pragma once

#include "signals/signal/signal_kind.h"

/// Amplitude modulation of a sine carrier by a slower sine:
/// (1 + d sin(2 pi m u)) / (1 + d) * sin(2 pi c u).
SignalKind am_kind();

/// Phase modulation of a sine carrier by a slower sine:
/// sin(2 pi c u + index sin(2 pi m u)), index in radians.
SignalKind fm_kind();
