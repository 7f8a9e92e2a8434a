#include "lab/frame/pass_control.h"

int PassControl::picture_pass() const {
    return m_work.document ? static_cast<int>(::picture_pass(m_work.document->look(), m_switches))
                           : 0;
}

void PassControl::toggle(PassSwitch which, const std::string& pass) {
    if (!m_work.document)
        return;
    const auto next = switched(m_work.document->look(), m_switches, which, pass);
    if (m_work.messages.succeeded(next))
        set(*next);
}

// Setting the same runs again would drop an unfinished frame.
Result<void> PassControl::set_runs(const std::vector<PassRun>& runs) {
    Executors& executors = m_work.renderer->executors();
    if (executors.picture().graph().settings().runs == runs)
        return {};
    return executors.for_both([&](Executor& executor) { return executor.set_runs(runs); });
}

// Frozen and left-out passes keep their last picture and are not redrawn.
void PassControl::set(const PassSwitches& switches) {
    if (!m_work.document || !m_work.renderer)
        return;
    const Look& look = m_work.document->look();
    const std::vector<PassRun> before = runs_of(look, m_switches);
    m_switches = known_switches(look, switches);
    const std::vector<PassRun> now = runs_of(look, m_switches);
    m_specialization.stop();
    if (!m_work.messages.succeeded(set_runs(now))) {
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
        m_work.redraw.add(redraw_of(look, changed));
}

void PassControl::clear_history(const std::string& pass) {
    const auto found = m_work.document ? find_pass(m_work.document->look(), pass) : std::nullopt;
    if (!found || !m_work.renderer)
        return;
    std::vector<bool> passes(m_work.document->look().passes.size(), false);
    passes[static_cast<std::size_t>(*found)] = true;
    clear(passes);
}

void PassControl::clear_history() {
    if (m_work.document && m_work.renderer)
        clear(std::vector<bool>(m_work.document->look().passes.size(), true));
}

// A paused picture is redrawn from the remaining history. Accumulating passes need earlier frames.
void PassControl::clear(const std::vector<bool>& passes) {
    const Look& look = m_work.document->look();
    m_work.renderer->replay().cancel();
    for (std::size_t i = 0; i < passes.size(); ++i)
        if (passes[i])
            static_cast<void>(m_work.renderer->executors().for_both([i](Executor& executor) {
                executor.clear_history(static_cast<int>(i));
                return Result<void>();
            }));
    Redraw redraw{dependents_of(look, passes)};
    for (std::size_t i = 0; i < look.passes.size(); ++i)
        redraw.needs_replay =
            redraw.needs_replay || (redraw.passes[i] && look.passes[i].accumulate);
    m_work.redraw.add(redraw);
}
