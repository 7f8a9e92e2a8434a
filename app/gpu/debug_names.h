#pragma once

#include <string_view>

namespace gpu {

class Canvas;
class Program;
class Texture;

/// Whether a debugger reads names of the current context's objects: the context was created for
/// debugging, or RenderDoc, apitrace or Nsight is attached. Then the driver has GL_KHR_debug.
/// Otherwise the functions below make no GL call.
bool is_debugged();

/// Names an object for debuggers. The name of a canvas is also that of its texture.
void set_label(const Texture& texture, std::string_view name);
void set_label(const Canvas& canvas, std::string_view name);
void set_label(const Program& program, std::string_view name);

/// Groups the GL calls of its lifetime under a name. Groups can be nested.
class DebugGroup {
public:
    explicit DebugGroup(std::string_view name);
    ~DebugGroup();
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;

private:
    bool m_is_open;
};

}  // namespace gpu
