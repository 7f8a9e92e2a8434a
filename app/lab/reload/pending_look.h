#pragma once

#include "base/pass_progress.h"
#include "graph/warm_up/first_views.h"
#include "lab/reload/built_look.h"

#include <memory>
#include <vector>

/// A built look that is warmed up in the context that will draw it, a few draws per update. The
/// open look continues meanwhile.
class PendingLook {
public:
    explicit PendingLook(BuiltLook built) : m_built(std::move(built)) {}

    /// What is drawn meanwhile.
    struct Beside {
        const Programs* shown;  // of the open look; null: none is open
        Extent picture;
    };
    /// Draws for about `seconds`; true when the look is ready to be shown.
    bool update(const Beside& beside, double seconds);
    PassProgress::State progress() const { return m_progress.state(); }
    const BuiltLook& built() const { return m_built; }
    BuiltLook take() { return std::move(m_built); }

private:
    void start(const Beside& beside);
    void start_draws(const Look& look, const Programs& programs, const Beside& beside);
    bool is_ready() const;
    void draw_next();

    BuiltLook m_built;
    PassProgress m_progress;
    bool m_has_started = false;
    std::vector<std::unique_ptr<FirstDraws>> m_draws;  // the last one is in progress
    std::shared_ptr<FirstViews> m_views;               // draws of the views
};
