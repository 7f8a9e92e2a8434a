#include "lab/reload/pending_look.h"

#include "base/elapsed.h"

void PendingLook::start(const OpenLook& open_look) {
    m_warm_up = std::make_unique<WarmUp>(m_built.programs ? m_built.programs->context : nullptr);
    if (!m_built.look || !m_built.programs || m_built.is_warm)
        return;
    const auto add_draws = [&](const Look& look, const Programs& programs) {
        m_warm_up->add_draws({look, programs, open_look.shown, m_built.images, open_look.picture});
    };
    add_draws(*m_built.look, *m_built.programs);
    if (m_built.specialized)
        add_draws(m_built.specialized->look, m_built.specialized->programs);
    m_warm_up->add_views(*m_built.look, *m_built.programs, open_look.picture,
                         values_of(m_built.request));
    if (m_warm_up->total() > 0)
        m_progress.begin(PassProgress::Step::drawing, m_warm_up->total());
}

bool PendingLook::update(const OpenLook& open_look, double seconds) {
    const auto begun = std::chrono::steady_clock::now();
    if (!m_warm_up)
        start(open_look);
    while (!m_warm_up->is_done() && seconds_since(begun) < seconds)
        m_warm_up->draw_next(m_progress);
    return m_warm_up->is_done();
}
