// The part of Lab that knows who looks at which passes.
#include "lab/lab.h"

// Where a number that is not finite is looked for, or others are compared with, every pass is to
// tell of its own.
void Lab::follow_seen() {
    const Executor& executor = m_renderer->executor();
    const std::vector<bool> seen =
        m_trip.trip || m_renderer->variant() ? std::vector<bool>() : m_seen.of(executor.look());
    if (seen == executor.seen())
        return;
    const Plan before = executor.plan();
    if (!m_messages.succeeded(m_renderer->set_seen(seen)))
        m_seen = {};
    if (executor.plan() == before)
        return;
    m_specialization.stop();
    want({std::vector<bool>(executor.look().passes.size(), true), false});
}
