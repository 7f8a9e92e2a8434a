#pragma once

#include "lab/session.h"
#include "lab/window/window_state.h"

#include <chrono>

/// Saves the session when a change is finished (a drag on release), otherwise about once a second.
/// A crash therefore loses almost no work.
class SessionAutosave {
public:
    explicit SessionAutosave(Roots roots) : m_roots(std::move(roots)) {}

    /// Call it in every update.
    void update(Lab& lab, const WindowState& window);
    void save(Lab& lab, const WindowState& window);

private:
    Roots m_roots;
    Session m_saved;
    std::optional<DocumentState> m_seen;
    std::chrono::steady_clock::time_point m_looked = std::chrono::steady_clock::now();
    bool m_has_failed = false;  // reported once
};
