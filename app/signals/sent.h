#pragma once

#include "signals/kinds.h"
#include "signals/sent_points.h"

SignalKind stdin_kind();
SignalKind socket_kind();

/// How the bytes of such a signal are to be read.
SentFormat sent_format(const Settings& settings);
