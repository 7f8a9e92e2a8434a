#pragma once

#include "model/plan/plan.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

/// The passes and frames to redraw in a paused picture.
class PendingRedraw {
public:
    void add(const Redraw& redraw) {
        if (!m_redraw) {
            m_redraw = redraw;
            return;
        }
        m_redraw->needs_replay = m_redraw->needs_replay || redraw.needs_replay;
        for (std::size_t i = 0; i < redraw.passes.size() && i < m_redraw->passes.size(); ++i)
            m_redraw->passes[i] = m_redraw->passes[i] || redraw.passes[i];
    }
    /// All passes of a look with this number of passes.
    void add_all(std::size_t passes) { add({std::vector<bool>(passes, true), false}); }
    /// Including earlier frames.
    void add_replay() { add({{}, true}); }
    /// Including all earlier frames of the player's past.
    void add_full_replay() {
        add_replay();
        m_replays_all = true;
    }
    bool replays_all() const { return m_redraw && m_replays_all; }
    bool is_empty() const { return !m_redraw; }
    bool needs_replay() const { return m_redraw && m_redraw->needs_replay; }
    void clear() {
        m_redraw.reset();
        m_replays_all = false;
    }
    Redraw take() {
        m_replays_all = false;
        return *std::exchange(m_redraw, std::nullopt);
    }

private:
    std::optional<Redraw> m_redraw;
    bool m_replays_all = false;
};
