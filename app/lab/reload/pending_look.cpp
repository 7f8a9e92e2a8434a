#include "lab/reload/pending_look.h"

#include "base/elapsed.h"

void PendingLook::start_draws(const Look& look, const Programs& programs, const Beside& beside) {
    if (!has_new(programs, beside.shown))
        return;
    const gpu::ContextScope scope(m_built.programs->home.get());  // `idle` is destroyed there, too
    const auto idle = idle_program();
    if (!idle)
        return;  // the first frame is slower
    m_draws.push_back(std::make_unique<FirstDraws>(
        FirstDrawsOf{look, programs, beside.shown, m_built.images, beside.picture}, *idle));
}

void PendingLook::start(const Beside& beside) {
    m_has_started = true;
    if (!m_built.look || !m_built.programs || m_built.is_warm)
        return;
    start_draws(*m_built.look, *m_built.programs, beside);
    if (m_built.specialized)
        start_draws(m_built.specialized->look, m_built.specialized->programs, beside);
    std::size_t total = 0;
    for (const auto& draws : m_draws)
        total += draws->total();
    if (total > 0)
        m_progress.begin(PassProgress::Step::drawing, total);
    const auto plan =
        plan_targets(*m_built.look, beside.picture, expected_source, values_of(m_built.request));
    m_views = m_built.programs->first_views;
    if (m_views && plan)
        m_views->expect(*m_built.look, *plan);
}

bool PendingLook::is_ready() const {
    return m_draws.empty() && (!m_views || m_views->pending() == 0);
}

void PendingLook::draw_next() {
    if (!m_draws.empty()) {
        FirstDraws& draws = *m_draws.back();
        m_progress.next(draws.next_pass());
        draws.draw_next();
        if (draws.is_done())
            m_draws.pop_back();
        return;
    }
    const gpu::ContextScope scope(m_built.programs->home.get());
    m_views->draw_next();
}

bool PendingLook::update(const Beside& beside, double seconds) {
    const auto begun = std::chrono::steady_clock::now();
    if (!m_has_started)
        start(beside);
    while (!is_ready() && seconds_since(begun) < seconds)
        draw_next();
    return is_ready();
}
