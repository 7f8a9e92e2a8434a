#pragma once

#include "lab/session.h"
#include "lab/window/window_state.h"

#include <chrono>

/// Writes what is open as soon as a change is done (a drag when the hand lets go), and all else
/// about once a second, so that a crash loses next to nothing.
class SessionKeeper {
public:
    explicit SessionKeeper(Roots roots) : m_roots(std::move(roots)) {}

    /// To be called every turn.
    void update(Lab& lab, const WindowState& window);
    void save(Lab& lab, const WindowState& window);

private:
    Roots m_roots;
    Session m_saved;
    std::optional<DocumentState> m_seen;
    std::chrono::steady_clock::time_point m_looked = std::chrono::steady_clock::now();
    bool m_has_failed = false;  // said once
};
