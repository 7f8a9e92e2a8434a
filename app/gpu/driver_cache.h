#pragma once

#include "base/pass_progress.h"

#include <chrono>
#include <cstddef>
#include <filesystem>

namespace gpu {

/// Disables the shader cache of Mesa's drivers if its folder has no space for a few MB. On a full
/// disk their writes to the mapped file end the program (SIGBUS). Call before the first context is
/// made; checks only once.
void check_driver_cache();

/// Whether a file of `bytes` bytes can be made in a folder, or in its nearest existing parent. True
/// if unknown.
bool has_free_space(const std::filesystem::path& folder, std::size_t bytes);

/// Waits until compiled shaders are in the driver's cache, where other contexts find them. Returns
/// after `maximum` or when `progress` is cancelled. Mesa writes them on a thread of lowest
/// priority, which can wait long on a busy machine. Other drivers have no such thread, so it
/// returns immediately.
void wait_for_driver_cache(std::chrono::milliseconds maximum, const PassProgress& progress);

}  // namespace gpu
