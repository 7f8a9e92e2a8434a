#pragma once

#include "gpu/context.h"
#include "graph/warm_up/first_views.h"

#include <future>
#include <memory>
#include <optional>
#include <vector>

/// A context that looks draw in, one after the other, and what they are looked at with there.
class LookContext {
public:
    explicit LookContext(std::unique_ptr<gpu::Context> context) : m_context(std::move(context)) {}
    LookContext(const LookContext&) = delete;
    LookContext& operator=(const LookContext&) = delete;
    ~LookContext();

    gpu::Context& context() const { return *m_context; }
    /// Makes the programs that views() waits for, unless they are there, in a context that shares
    /// with its own: who reads a look meanwhile works in that one.
    void have_programs();
    /// While its context is current.
    Result<FirstViews*> views();

private:
    using MadePrograms = Result<std::shared_ptr<const ViewPrograms>>;

    std::unique_ptr<gpu::Context> m_context;
    bool m_has_programs = false;
    std::promise<MadePrograms> m_making;
    std::shared_future<MadePrograms> m_programs = m_making.get_future().share();
    std::optional<FirstViews> m_views;
};

/// Contexts that looks draw in. A driver makes a program's code for the context that first draws
/// with it, perhaps for a long time; so a look that is opened draws first in a context of its own,
/// on another thread, and then goes on drawing in it on the window's.
class LookContexts {
public:
    /// All share with `screen`, which stays longer.
    explicit LookContexts(const gpu::Context& screen) : m_screen(screen) {}
    ~LookContexts();
    LookContexts(const LookContexts&) = delete;
    LookContexts& operator=(const LookContexts&) = delete;

    /// On the thread of `screen`, whose turn it then is to have_programs(): one that is nobody's,
    /// until it is given back by its last owner, on any thread. Null where the driver gives none.
    std::shared_ptr<LookContext> acquire();
    /// The next acquire() finds one with programs; making it may take a driver a while.
    void have_spare();

private:
    const gpu::Context& m_screen;
    std::vector<std::shared_ptr<LookContext>> m_all;
    bool m_has_failed = false;
};
