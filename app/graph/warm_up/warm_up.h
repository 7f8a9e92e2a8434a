#pragma once

#include "base/pass_progress.h"
#include "graph/warm_up/first_draws.h"
#include "graph/warm_up/first_views.h"

#include <cstddef>
#include <memory>
#include <vector>

/// Warms up looks in the context that will draw them, a few draws at a time: draws once with each
/// new program, then displays each kind of picture. A driver compiles a program at these draws, so
/// that no visible frame waits for it.
class WarmUp {
public:
    /// `context` will draw the looks; null: the current one.
    explicit WarmUp(std::shared_ptr<gpu::Context> context) : m_context(std::move(context)) {}
    ~WarmUp();
    WarmUp(const WarmUp&) = delete;
    WarmUp& operator=(const WarmUp&) = delete;

    /// Adds the new programs of a look. Without memory they are left out, and the first frame is
    /// slower.
    void add_draws(const FirstDrawsInput& of);
    /// Adds the kinds of pictures of a look that were not displayed yet in this context. `viewport`
    /// is the size of the picture, px; `values` are those that sizes depend on.
    void add_views(const Look& look, const Programs& programs, Extent viewport,
                   const Values& values);

    /// Programs to draw with.
    std::size_t total() const;
    bool is_done() const;
    /// Draws once and waits for it. Notes the pass of a program in `progress`. False if that was
    /// cancelled.
    bool draw_next(PassProgress& progress);
    /// Draws everything unless cancelled.
    void draw_all(PassProgress& progress);
    /// The executor of the draws that were added last; see FirstDraws. Null without memory.
    std::unique_ptr<Executor> take_executor();

private:
    FirstDraws* unfinished_draws();

    std::shared_ptr<gpu::Context> m_context;
    std::vector<std::unique_ptr<FirstDraws>> m_draws;
    std::shared_ptr<FirstViews> m_views;  // null: no views
};
