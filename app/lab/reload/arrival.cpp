#include "lab/reload/arrival.h"

#include "base/elapsed.h"

// What it will be drawn with.
const Look& Arrival::drawn_look() const {
    return m_loaded.settled ? m_loaded.settled->look : *m_loaded.look;
}

const Programs& Arrival::drawn_programs() const {
    return m_loaded.settled ? m_loaded.settled->programs : *m_loaded.programs;
}

void Arrival::start_draws(const Beside& beside) {
    const gpu::ContextScope scope(m_loaded.programs->home.get());  // it ends there, too
    const auto idle = idle_program();
    if (!idle)
        return;  // the first frame is slower
    m_draws = std::make_unique<FirstDraws>(
        FirstDrawsOf{drawn_look(), drawn_programs(), beside.shown, m_loaded.images, beside.picture},
        *idle);
    m_progress.begin(PassProgress::Step::drawing, m_draws->total());
}

void Arrival::start(const Beside& beside) {
    m_has_started = true;
    if (!m_loaded.look || !m_loaded.programs || m_loaded.is_warm)
        return;
    if (has_new(drawn_programs(), beside.shown))
        start_draws(beside);
    const auto plan =
        plan_targets(*m_loaded.look, beside.picture, expected_source, values_of(m_loaded.request));
    m_views = m_loaded.programs->first_views;
    if (m_views && plan)
        m_views->expect(*m_loaded.look, *plan);
}

bool Arrival::is_ready() const {
    return (!m_draws || m_draws->is_done()) && (!m_views || m_views->owed() == 0);
}

void Arrival::draw_next() {
    if (m_draws && !m_draws->is_done()) {
        m_progress.next(m_draws->next_pass());
        return m_draws->draw_next();
    }
    const gpu::ContextScope scope(m_loaded.programs->home.get());
    m_views->draw_next();
}

bool Arrival::go_on(const Beside& beside, double seconds) {
    const auto begun = std::chrono::steady_clock::now();
    if (!m_has_started)
        start(beside);
    while (!is_ready() && seconds_since(begun) < seconds)
        draw_next();
    return is_ready();
}
