#pragma once

#include "lab/reload/reloader.h"

#include <memory>
#include <vector>

/// A look that has been read and linked, and whose programs the drawing context draws with for the
/// first time, a few a turn, while what was open goes on.
class Arrival {
public:
    explicit Arrival(LoadedRequest loaded) : m_loaded(std::move(loaded)) {}

    /// What the first draws are made beside.
    struct Beside {
        const Programs* shown;  // of what is open; null: nothing is
        Extent picture;
    };
    /// Goes on for about `seconds`; true when it is ready to be seen.
    bool go_on(const Beside& beside, double seconds);
    PassProgress::State progress() const { return m_progress.state(); }
    const LoadedRequest& loaded() const { return m_loaded; }
    LoadedRequest take() { return std::move(m_loaded); }

private:
    void start(const Beside& beside);
    void start_draws(const Look& look, const Programs& programs, const Beside& beside);
    bool is_ready() const;
    void draw_next();

    LoadedRequest m_loaded;
    PassProgress m_progress;
    bool m_has_started = false;
    std::vector<std::unique_ptr<FirstDraws>> m_draws;  // those left; the last one is under way
    std::shared_ptr<FirstViews> m_views;               // the same of who looks at it
};
