#pragma once

#include "base/pass_progress.h"

#include <chrono>
#include <cstddef>
#include <filesystem>

namespace gpu {

/// Tells Mesa's drivers to do without their shader cache where its folder cannot take a few MB:
/// they write it through memory that the disk does not back then, which ends the program (SIGBUS).
/// To be called before the first context is made; looks once.
void check_driver_cache();

/// Whether a file of so many bytes can be made in a folder, or in the nearest one above it that
/// exists. True where that cannot be found out.
bool has_room(const std::filesystem::path& folder, std::size_t bytes);

/// Waits until what the driver has compiled is in its cache, where other contexts find it, or
/// `most` is over or `progress` is cancelled. Mesa writes that on a thread of least priority, which
/// a busy machine may leave waiting for long; other drivers have no such thread, and nothing is
/// waited for.
void wait_for_driver_cache(std::chrono::milliseconds most, const PassProgress& progress);

}  // namespace gpu
