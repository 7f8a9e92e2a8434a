#pragma once

#include "signals/signal/signal_kind.h"

/// Two function generators: as two traces over time (yt), or one as x and one as y (xy).
SignalKind waveform_kind();
