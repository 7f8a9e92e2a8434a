#pragma once

#include "signals/signal/signal_kind.h"

/// A sum of sines at whole multiples of a base frequency.
SignalKind harmonics_kind();
