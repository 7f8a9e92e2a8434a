#pragma once

#include "signals/beam/sent_points.h"
#include "signals/signal/signal_kind.h"

SignalKind stdin_kind();
SignalKind socket_kind();

/// How the bytes of such a signal are to be read.
SentFormat sent_format(const Settings& settings);
