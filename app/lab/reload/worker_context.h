#pragma once

#include "gpu/context.h"

#include <memory>
#include <mutex>
#include <optional>

/// The GL context of the worker thread. It is created when it is first needed, because this can
/// take a while. Until then the worker borrows the context of a look that is being opened.
class WorkerContext {
public:
    /// `screen` is the context of the window's thread and outlives this. `own` shares objects with
    /// it; null: create() creates one.
    WorkerContext(std::unique_ptr<gpu::Context> own, const gpu::Context& screen)
        : m_screen(screen), m_own(std::move(own)) {}

    /// On the window's thread: creates the worker's own context, once.
    void create();
    /// Whether create() was called, or is not necessary.
    bool is_created() const;

    // On the worker thread.
    /// Makes its own context current; false: it does not exist yet.
    bool use_own();
    /// Makes its own context current, or `look_context` for as long as `scope`. False: neither
    /// exists.
    bool use(const std::shared_ptr<gpu::Context>& look_context,
             std::optional<gpu::ContextScope>& scope);
    /// The owner of objects that were created in the context of a look; null: they belong to its
    /// own.
    const std::shared_ptr<gpu::Context>& look_context() const { return m_look_context; }
    /// Releases both.
    void release();

private:
    const gpu::Context& m_screen;
    mutable std::mutex m_mutex;
    std::unique_ptr<gpu::Context> m_own;
    bool m_was_tried = false;
    std::shared_ptr<gpu::Context> m_look_context;
};
