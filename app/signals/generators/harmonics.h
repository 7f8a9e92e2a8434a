#pragma once

#include "signals/signal/signal_kind.h"

/// A sum of sines at integer multiples of a base frequency.
SignalKind harmonics_kind();
