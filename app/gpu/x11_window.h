#pragma once

#include "gpu/window.h"

#include <cstdint>

namespace gpu {

/// The window's number on its X server, for dialogs of other programs; 0: it has none.
std::uint64_t x11_window(const Window& window);

}  // namespace gpu
