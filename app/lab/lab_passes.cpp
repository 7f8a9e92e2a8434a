// The part of Lab that switches passes, so that a person sees what each of them does.
#include "lab/lab.h"

int Lab::picture_pass() const {
    return m_document ? static_cast<int>(::picture_pass(m_document->look(), m_switches)) : 0;
}

void Lab::switch_pass(PassSwitch which, const std::string& pass) {
    if (!m_document)
        return;
    const auto next = switched(m_document->look(), m_switches, which, pass);
    if (m_messages.succeeded(next))
        set_pass_switches(*next);
}

// What is frozen or left out from now on shows what it has; all else is drawn anew, also in a
// picture that rests.
void Lab::set_pass_switches(const PassSwitches& switches) {
    if (!m_document || !m_renderer)
        return;
    const Look& look = m_document->look();
    const std::vector<PassRun> before = runs_of(look, m_switches);
    m_switches = known_switches(look, switches);
    const std::vector<PassRun> now = runs_of(look, m_switches);
    m_specialization.stop();
    if (!m_messages.succeeded(m_renderer->set_runs(now))) {
        m_switches = {};
        return;
    }
    std::vector<bool> changed(look.passes.size(), false);
    bool is_any = false;
    for (std::size_t i = 0; i < changed.size(); ++i) {
        const PassRun was = i < before.size() ? before[i] : PassRun::drawn;
        const PassRun is = i < now.size() ? now[i] : PassRun::drawn;
        changed[i] = was != is && (is == PassRun::drawn || is == PassRun::bypassed);
        is_any = is_any || changed[i];
    }
    if (is_any)
        want(redraw_of(look, changed));
}

void Lab::clear_history(const std::string& pass) {
    const auto found = m_document ? find_pass(m_document->look(), pass) : std::nullopt;
    if (!found || !m_renderer)
        return;
    std::vector<bool> passes(m_document->look().passes.size(), false);
    passes[static_cast<std::size_t>(*found)] = true;
    forget_passes(passes);
}

void Lab::clear_history() {
    if (m_document && m_renderer)
        forget_passes(std::vector<bool>(m_document->look().passes.size(), true));
}

// A picture that rests is drawn again of what is left; samples take a past to gather.
void Lab::forget_passes(const std::vector<bool>& passes) {
    const Look& look = m_document->look();
    m_renderer->cancel_replay();
    for (std::size_t i = 0; i < passes.size(); ++i)
        if (passes[i])
            m_renderer->clear_history(static_cast<int>(i));
    Redraw redraw{reached_from(look, passes)};
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        redraw.needs_replay =
            redraw.needs_replay || (redraw.passes[i] && look.passes[i].accumulate);
    want(redraw);
}
