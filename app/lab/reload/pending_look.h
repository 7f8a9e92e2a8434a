#pragma once

#include "graph/warm_up/warm_up.h"
#include "lab/reload/built_look.h"

#include <memory>

/// A built look that is warmed up in the context that will draw it, a few draws per update. The
/// open look continues meanwhile.
class PendingLook {
public:
    explicit PendingLook(BuiltLook built) : m_built(std::move(built)) {}

    /// What is drawn meanwhile.
    struct OpenLook {
        const Programs* shown;  // of the open look; null: none is open
        Extent picture;
    };
    /// Draws for about `seconds`; true when the look is ready to be shown.
    bool update(const OpenLook& open_look, double seconds);
    PassProgress::State progress() const { return m_progress.state(); }
    const BuiltLook& built() const { return m_built; }
    BuiltLook take() { return std::move(m_built); }

private:
    void start(const OpenLook& open_look);

    BuiltLook m_built;
    PassProgress m_progress;
    std::unique_ptr<WarmUp> m_warm_up;  // null: not started
};
