#pragma once

#include "signals/kinds.h"

/// Two wave generators: as two traces over time (yt), or one across and one up (xy).
SignalKind waveform_kind();
