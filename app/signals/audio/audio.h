#pragma once

#include "signals/signal/signal_kind.h"

/// A sound on a scope: left as x and right as y (xy), or one trace over time (waveform).
SignalKind audio_kind();
/// The same for live sound from an audio device.
SignalKind microphone_kind();
