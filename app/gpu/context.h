#pragma once

#include "base/diagnostic.h"

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace gpu {

class Program;

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

/// Whether the driver has lost the current context, with all that it holds. Contexts that are not
/// robust are never told.
bool was_reset();

/// What an OpenGL 4.1 core context makes its own: where GL's objects live. Current on one thread at
/// a time, and on it when it or its objects end.
class Context {
public:
    virtual ~Context();
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

    /// The one that is current on this thread; null: none is.
    static Context* current();
    void make_current();
    /// Current on no thread; another may take it.
    void release();
    /// From any thread: `object` ends when this context is current next, or with it.
    void bury(std::unique_ptr<const Program> object);
    const Facts& facts() const { return m_facts; }

protected:
    Context();
    virtual Result<std::unique_ptr<Context>> make_sharing() const = 0;
    virtual void take_thread() = 0;
    virtual void leave_thread() = 0;

    Facts m_facts;

private:
    void end_buried();

    std::mutex m_mutex;
    std::vector<std::unique_ptr<const Program>> m_buried;
};

/// While it lives another context that shares with the current one is current. Each sees what the
/// other has drawn before.
class ContextScope {
public:
    /// Null, or the current one: nothing changes.
    explicit ContextScope(Context* context);
    ~ContextScope();
    ContextScope(const ContextScope&) = delete;
    ContextScope& operator=(const ContextScope&) = delete;

private:
    Context* m_before = nullptr;
    Context* m_context = nullptr;  // null: nothing was changed
};

}  // namespace gpu
