#include "lab/reload/worker_context.h"

#include <utility>

void WorkerContext::create() {
    {
        const std::lock_guard lock(m_mutex);
        if (m_own || std::exchange(m_was_tried, true))
            return;
    }
    auto made = gpu::Context::shared_with(m_screen);
    if (!made)
        return;  // jobs that need it report that
    const std::lock_guard lock(m_mutex);
    m_own = std::move(*made);
}

bool WorkerContext::is_created() const {
    const std::lock_guard lock(m_mutex);
    return m_own || m_was_tried;
}

bool WorkerContext::use_own() {
    const std::lock_guard lock(m_mutex);
    if (!m_own)
        return false;
    if (gpu::Context::current() != m_own.get())
        m_own->make_current();
    m_look_context.reset();
    return true;
}

bool WorkerContext::use(const std::shared_ptr<gpu::Context>& look_context,
                        std::optional<gpu::ContextScope>& scope) {
    if (use_own())
        return true;
    if (!look_context)
        return false;
    m_look_context = look_context;
    scope.emplace(m_look_context.get());
    return true;
}

void WorkerContext::release() {
    m_look_context.reset();
    if (gpu::Context* const own = gpu::Context::current())
        own->release();
}
