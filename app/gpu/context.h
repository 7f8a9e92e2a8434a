#pragma once

#include "base/diagnostic.h"

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace gpu {

class Program;

/// Properties that the driver of a context reports.
struct DriverInfo {
    std::string renderer;
    std::string vendor;
    std::string version;
    int largest_texture = 0;          // side, px
    float largest_point_size = 0.0f;  // px
    bool is_debugged = false;         // a debugger reads names; see debug_names.h
};

/// Reads them from the current context.
DriverInfo read_info();

/// Whether the driver has lost the current context and all its objects. Always false for contexts
/// without robustness.
bool was_reset();

/// An OpenGL 4.1 core context, which owns GL objects. Current on at most one thread at a time. It
/// must be current when it or its objects are destroyed.
class Context {
public:
    virtual ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    /// A context for a worker thread that shares the textures, buffers and programs of `context`.
    /// Call it on the thread of `context`. The new context is not current on any thread.
    static Result<std::unique_ptr<Context>> shared_with(const Context& context) {
        return context.make_sharing();
    }

    /// The context that is current on this thread, or null.
    static Context* current();
    void make_current();
    /// Makes it current on no thread, so that another thread can use it.
    void release();
    /// From any thread: `object` is destroyed when this context next becomes current, or with this
    /// context.
    void destroy_later(std::unique_ptr<const Program> object);
    const DriverInfo& info() const { return m_info; }

protected:
    Context();
    virtual Result<std::unique_ptr<Context>> make_sharing() const = 0;
    virtual void take_thread() = 0;
    virtual void leave_thread() = 0;

    DriverInfo m_info;

private:
    void destroy_pending();

    std::mutex m_mutex;
    std::vector<std::unique_ptr<const Program>> m_pending_destruction;
};

/// Makes another context, shared with the current one, current for its lifetime. Each context sees
/// the previous draws of the other.
class ContextScope {
public:
    /// Null or the current context: no change.
    explicit ContextScope(Context* context);
    ~ContextScope();
    ContextScope(const ContextScope&) = delete;
    ContextScope& operator=(const ContextScope&) = delete;

private:
    Context* m_before = nullptr;
    Context* m_context = nullptr;  // null: no change
};

}  // namespace gpu
