#pragma once

namespace gpu {

/// Whether RenderDoc started the program, so that its library is loaded.
bool has_renderdoc();

/// Makes RenderDoc capture the next frame that a window shows. Does nothing without it.
void capture_next_frame();

}  // namespace gpu
