#pragma once

#include "gpu/context.h"

#include <memory>

namespace gpu {

/// The context that is current on this thread, as GLX names it on its display.
struct GlxPlace {
    void* display = nullptr;  // null: it is none of GLX
    void* context = nullptr;
};
GlxPlace current_glx_place();

/// A context that shares with the one there, and has no window: a toolkit looks through all kinds
/// of pictures that the display has for each window, which takes ten times as long as the context.
/// `facts` are those of both. To be called on the thread that listens to the display, which
/// stays open for longer. Null: there is none to be had.
std::unique_ptr<Context> share_through_glx(const GlxPlace& place, const Facts& facts);

}  // namespace gpu
