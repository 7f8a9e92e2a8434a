// The part of Executor that detects NaN and infinity.
#include "graph/executor/executor.h"

#include <algorithm>

Result<void> Executor::set_nan_policy(NanPolicy guard) {
    const gpu::ContextScope scope(m_home.get());
    const auto holds_floats = [](const PlannedTarget& target) {
        return facts_of(target.format).is_float;
    };
    if (guard != NanPolicy::off && !m_nan_detector &&
        std::ranges::any_of(m_plan.targets, holds_floats)) {
        auto programs = m_programs.nan_detector;
        if (!programs) {
            auto built = build_nan_detector();
            if (!built)
                return fail(built.error());
            programs = std::move(*built);
        }
        m_nan_detector.emplace(std::move(programs));
    }
    if (guard != m_guard && m_nan_detector)
        m_nan_detector->clear();
    m_guard = guard;
    return {};
}

bool Executor::is_remembered(std::size_t pass) const {
    return m_plan.targets[pass].slots > 1 || m_look.passes[pass].accumulate;
}

bool Executor::is_watched(std::size_t pass) const {
    if (m_guard == NanPolicy::off || !m_nan_detector || host_of(pass) != pass ||
        !facts_of(m_plan.targets[pass].format).is_float)
        return false;
    const bool is_next = static_cast<std::size_t>(m_drawn.number) % m_passes.size() == pass;
    switch (m_guard) {
        case NanPolicy::watch:
            return is_remembered(pass) || is_next;
        case NanPolicy::clamp:
            return is_remembered(pass) || m_draws_whole;
        default:
            return true;
    }
}

// Another pass may have overwritten its picture of this frame.
bool Executor::is_released(std::size_t pass) const {
    const PlannedTarget& target = m_plan.targets[pass];
    return target.common && target.slots == 1 && target.held_until != m_order.back();
}

// Directly after the draw: before later passes read the picture, or before it is overwritten.
void Executor::check_pass(std::size_t pass) {
    if (!is_watched(pass))
        return;
    const NanDetector::Drawn drawn{pass, &m_targets[pass].canvas()};
    if (m_guard == NanPolicy::clamp)
        m_nan_detector->check_and_sanitize(drawn, m_drawn.number);
    else if (is_released(pass))
        m_nan_detector->look_at({&drawn, 1}, m_drawn.number);
}

// All other passes together, after the frame.
void Executor::check_frame() {
    if (m_guard == NanPolicy::clamp)
        return check_cause(m_work.passes);
    std::vector<NanDetector::Drawn> all;
    for (std::size_t pass = 0; pass < m_passes.size(); ++pass)
        if (m_work.passes[pass] && is_watched(pass) && !is_released(pass))
            all.push_back({pass, &m_targets[pass].canvas()});
    if (!all.empty())
        m_nan_detector->look_at(all, m_drawn.number);
}

// If a stored picture was corrected, an earlier pass that is not watched may be the cause.
void Executor::check_cause(const std::vector<bool>& drawn) {
    if (m_draws_whole || !m_nan_detector)
        return;
    for (std::size_t cause = 0; cause < m_passes.size(); ++cause)
        for (std::size_t pass = 0; pass < cause; ++pass)
            if (drawn[pass] && drawn[cause] && is_watched(cause) && !is_watched(pass) &&
                !is_released(pass) && facts_of(m_plan.targets[pass].format).is_float)
                m_nan_detector->check_cause(cause, pass, m_targets[pass].canvas(), m_drawn.number);
}

std::optional<NonFinitePixel> Executor::take_non_finite(bool waits) {
    const gpu::ContextScope scope(m_home.get());
    std::optional<NonFinitePixel> trip =
        m_nan_detector ? m_nan_detector->take(waits) : std::nullopt;
    if (trip && m_look.passes[trip->pass].rows == RowOrder::top_first)
        trip->y = m_plan.targets[trip->pass].extent.height - 1 - trip->y;
    return trip;
}

void Executor::sanitize() {
    const gpu::ContextScope scope(m_home.get());
    if (!m_nan_detector)
        return;
    for (std::size_t pass = 0; pass < m_targets.size(); ++pass) {
        if (!facts_of(m_plan.targets[pass].format).is_float)
            continue;
        for (int ago = 0; ago < m_plan.targets[pass].slots; ++ago) {
            m_nan_detector->sanitize(m_targets[pass].canvas(ago));
            m_targets[pass].canvas(ago).texture().generate_mipmaps();
        }
    }
}
