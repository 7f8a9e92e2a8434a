#pragma once

#include "signals/signal/signal_kind.h"

SignalKind text_kind();
SignalKind scene_kind();
SignalKind drawing_kind();
