// The part of Executor that looks for numbers that are not finite.
#include "graph/executor.h"

Result<void> Executor::set_guard(Guard guard) {
    if (guard != Guard::off && !m_tripwire) {
        auto made = Tripwire::make();
        if (!made)
            return fail(made.error());
        m_tripwire.emplace(std::move(*made));
    }
    if (guard != m_guard && m_tripwire)
        m_tripwire->clear();
    m_guard = guard;
    return {};
}

bool Executor::is_watched(std::size_t pass, std::int64_t frame) const {
    if (m_guard == Guard::off || !facts_of(m_plan.targets[pass].format).is_float)
        return false;
    const bool is_kept = m_plan.targets[pass].slots > 1 || m_look.passes[pass].accumulate;
    const bool is_next = static_cast<std::size_t>(frame) % m_passes.size() == pass;
    return m_guard == Guard::clamp || is_kept || is_next;
}

std::optional<Trip> Executor::take_trip(bool waits) {
    return m_tripwire ? m_tripwire->take(waits) : std::nullopt;
}

void Executor::mend() {
    if (!m_tripwire)
        return;
    for (std::size_t pass = 0; pass < m_targets.size(); ++pass) {
        if (!facts_of(m_plan.targets[pass].format).is_float)
            continue;
        for (int ago = 0; ago < m_plan.targets[pass].slots; ++ago) {
            m_tripwire->mend(pass, m_targets[pass].canvas(ago));
            m_targets[pass].canvas(ago).texture().generate_mipmaps();
        }
    }
}
