#pragma once

#include "gpu/context.h"
#include "graph/warm_up/first_views.h"

#include <future>
#include <memory>
#include <optional>
#include <vector>

/// A context that looks draw in, one after the other, with the programs that display them there.
class LookContext {
public:
    explicit LookContext(std::unique_ptr<gpu::Context> context) : m_context(std::move(context)) {}
    LookContext(const LookContext&) = delete;
    LookContext& operator=(const LookContext&) = delete;
    ~LookContext();

    gpu::Context& context() const { return *m_context; }
    /// Builds the programs that views() waits for, once. Runs in a context that shares with this
    /// one, because the worker thread uses this one to read a look meanwhile.
    void build_view_programs();
    /// Call while its context is current.
    Result<FirstViews*> views();

private:
    using MadePrograms = Result<std::shared_ptr<const ViewPrograms>>;

    std::unique_ptr<gpu::Context> m_context;
    bool m_has_programs = false;
    std::promise<MadePrograms> m_making;
    std::shared_future<MadePrograms> m_programs = m_making.get_future().share();
    std::optional<FirstViews> m_views;
};

/// The contexts that looks draw in. A driver compiles a program for the context that first draws
/// with it, which may take long. A look that is opened therefore first draws in its own context on
/// the worker thread. It then continues to draw in it on the window's thread.
class LookContexts {
public:
    /// All share with `screen`, which must outlive them.
    explicit LookContexts(const gpu::Context& screen) : m_screen(screen) {}
    ~LookContexts();
    LookContexts(const LookContexts&) = delete;
    LookContexts& operator=(const LookContexts&) = delete;

    /// An unused context, which its last owner releases on any thread. Null if the driver cannot
    /// create one. Call on the thread of `screen`, then call build_view_programs() there.
    std::shared_ptr<LookContext> acquire();
    /// Prepares a context with programs for the next acquire(), as creating it can take a while.
    void prepare_spare();

private:
    const gpu::Context& m_screen;
    std::vector<std::shared_ptr<LookContext>> m_all;
    bool m_has_failed = false;
};
