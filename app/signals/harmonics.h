#pragma once

#include "signals/kinds.h"

/// A sum of sines at whole multiples of a base frequency.
SignalKind harmonics_kind();
