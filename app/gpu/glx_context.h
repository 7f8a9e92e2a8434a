#pragma once

#include "gpu/context.h"

#include <memory>

namespace gpu {

/// The context that is current on this thread, as GLX handles.
struct GlxHandles {
    void* display = nullptr;  // null: not a GLX context
    void* context = nullptr;
};
GlxHandles current_glx_handles();

/// A context without a window that shares with the one at `handles`. A toolkit enumerates all
/// framebuffer configurations for each window, which takes ten times as long as creating the
/// context. `info` are those of both contexts. Call it on the thread that handles the display,
/// which must outlive the context. Null on failure.
std::unique_ptr<Context> share_through_glx(const GlxHandles& handles, const DriverInfo& info);

}  // namespace gpu
