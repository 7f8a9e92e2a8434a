#pragma once

#include "base/job_progress.h"
#include "signals/signal/signal.h"

#include <filesystem>

/// Loads the file of a signal: a scene or drawing by its name, otherwise a sound. `notes`: warnings
/// about a usable file.
Result<SignalMedia> load_signal_media(const std::filesystem::path& file,
                                      JobProgress* work = nullptr, Diagnostics* notes = nullptr);
