#pragma once

#include "base/work.h"
#include "signals/signal/signal.h"

#include <filesystem>

/// Loads the file of a signal: a scene or drawing by its name, otherwise a sound. `notes`: warnings
/// about a usable file.
Result<SignalMedia> load_signal_media(const std::filesystem::path& file, Work* work = nullptr,
                                      Diagnostics* notes = nullptr);
