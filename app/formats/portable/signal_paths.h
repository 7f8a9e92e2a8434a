#pragma once

#include "base/diagnostic.h"
#include "model/look/spec.h"
#include "signals/signal/signal.h"

#include <nlohmann/json_fwd.hpp>

/// The lines of a text, scene or drawing, see docs/portable.md; null for other signals.
Result<nlohmann::ordered_json> signal_paths(const Spec& completed, const SignalMedia& media);
