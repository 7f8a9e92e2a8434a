#pragma once

#include "gpu/context.h"

#include <memory>

namespace gpu {

/// A context without a window or display server, through EGL, current on this thread. Tries
/// hardware devices first, then software; only software if LIBGL_ALWAYS_SOFTWARE is set.
/// With `is_for_debugging`, debuggers can read names of its objects; see debug_names.h.
Result<std::unique_ptr<Context>> create_headless_context(bool is_for_debugging = false);

}  // namespace gpu
