#pragma once

#include "signals/beam/beam_input_points.h"
#include "signals/signal/signal_kind.h"

SignalKind stdin_kind();
SignalKind socket_kind();

/// The byte format of such a signal.
BeamInputFormat beam_input_format(const Settings& settings);
