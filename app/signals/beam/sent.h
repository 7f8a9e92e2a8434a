#pragma once

#include "signals/beam/sent_points.h"
#include "signals/signal/signal_kind.h"

SignalKind stdin_kind();
SignalKind socket_kind();

/// The byte format of such a signal.
SentFormat sent_format(const Settings& settings);
