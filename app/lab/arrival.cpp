#include "lab/arrival.h"

#include "base/elapsed.h"

void Arrival::start(const Beside& beside) {
    m_has_started = true;
    if (!m_loaded.look || !m_loaded.programs || m_loaded.is_warm)
        return;
    const gpu::ContextScope scope(m_loaded.programs->home.get());  // it ends there, too
    const auto idle = idle_program();
    if (!idle)
        return;  // the first frame is slower
    m_draws =
        std::make_unique<FirstDraws>(FirstDrawsOf{*m_loaded.look, *m_loaded.programs, beside.shown,
                                                  m_loaded.images, beside.picture},
                                     *idle);
    m_progress.begin(PassProgress::Step::drawing, m_draws->total());
}

bool Arrival::go_on(const Beside& beside, double seconds) {
    const auto begun = std::chrono::steady_clock::now();
    if (!m_has_started)
        start(beside);
    while (m_draws && !m_draws->is_done() && seconds_since(begun) < seconds) {
        m_progress.next(m_draws->next_pass());
        m_draws->draw_next();
    }
    return !m_draws || m_draws->is_done();
}
