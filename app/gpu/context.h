#pragma once

#include "base/diagnostic.h"

#include <memory>
#include <string>

namespace gpu {

/// What the driver of a context says of itself.
struct Facts {
    std::string renderer;
    std::string vendor;
    std::string version;
    int largest_texture = 0;          // a side, px
    float largest_point_size = 0.0f;  // px
};

/// Of the current context.
Facts read_facts();

/// What an OpenGL 4.1 core context makes its own: where GL's objects live. Current on one thread at
/// a time, and on it when it or its objects end.
class Context {
public:
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// A context without a window or display server, through EGL, current on this thread. Tries
    /// graphics devices first, then software; only software where LIBGL_ALWAYS_SOFTWARE is set.
    static Result<std::unique_ptr<Context>> headless();
    /// A context for a helper thread that sees the textures, buffers and programs of `context`; it
    /// is made on the thread of `context` and is current nowhere.
    static Result<std::unique_ptr<Context>> shared_with(const Context& context) {
        return context.make_sharing();
    }

    virtual void make_current() = 0;
    /// Current on no thread; another may take it.
    virtual void release() = 0;
    const Facts& facts() const { return m_facts; }

protected:
    Context() = default;
    virtual Result<std::unique_ptr<Context>> make_sharing() const = 0;

    Facts m_facts;
};

}  // namespace gpu
