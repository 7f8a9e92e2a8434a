#pragma once

#include "base/work.h"
#include "signals/signal/signal.h"

#include <filesystem>

/// What a signal's file holds: a scene or drawing by its name, else a sound. `notes`: what is amiss
/// with a file that can be used all the same.
Result<SignalMedia> load_signal_media(const std::filesystem::path& file, Work* work = nullptr,
                                      Diagnostics* notes = nullptr);
