#pragma once

#include "signals/signal/signal_kind.h"

/// Two wave generators: as two traces over time (yt), or one across and one up (xy).
SignalKind waveform_kind();
