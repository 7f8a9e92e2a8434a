#pragma once

#include "signals/signal/signal_kind.h"

/// x = A sin(2 pi (x u + phase + speed t)), y = A sin(2 pi y u), u = 60 t.
SignalKind lissajous_kind();
