#pragma once

#include "base/pass_progress.h"

#include <chrono>

namespace gpu {

/// Waits until what the driver has compiled is in its cache, where other contexts find it, or
/// `most` is over or `progress` is cancelled. Mesa writes that on a thread of least priority, which
/// a busy machine may leave waiting for long; other drivers have no such thread, and nothing is
/// waited for.
void wait_for_driver_cache(std::chrono::milliseconds most, const PassProgress& progress);

}  // namespace gpu
