#include "lab/session/session_autosave.h"

#include "lab/window/window_session.h"

void SessionAutosave::update(Lab& lab, const WindowState& window) {
    constexpr auto pause = std::chrono::seconds(1);
    const auto now = std::chrono::steady_clock::now();
    const Document* document = lab.document();
    const bool is_done = document && !document->history().is_in_gesture();
    const bool is_new = is_done && m_seen != document->state();
    if (lab.loader().is_loading() || (!is_new && now - m_looked < pause))
        return;
    if (is_new)
        m_seen = document->state();
    m_looked = now;
    save(lab, window);
}

void SessionAutosave::save(Lab& lab, const WindowState& window) {
    Session session = session_of(lab, serialized_window(window));
    if (session.look.empty())
        return;  // no look was opened: keep the saved session
    // Elapsed time alone is not a change; it is saved with other changes.
    m_saved.time = session.time;
    if (session == m_saved)
        return;
    const auto saved = save_session(m_roots, session);
    if (!saved && !m_has_failed)
        lab.messages().say(saved.error().front());
    m_has_failed = !saved;
    m_saved = std::move(session);
}
