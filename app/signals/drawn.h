#pragma once

#include "signals/kinds.h"

SignalKind text_kind();
SignalKind scene_kind();
SignalKind drawing_kind();
