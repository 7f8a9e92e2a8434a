#pragma once

#include "signals/signal/signal_kind.h"

/// A sound on a scope: left across and right up (xy), or one trace over time (waveform).
SignalKind audio_kind();
/// The same for a sound that comes in from a device.
SignalKind microphone_kind();
