#include "base/pass_progress.h"

#include "base/elapsed.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

PassProgress::PassProgress(Listener listener) : m_listener(std::move(listener)) {}

void PassProgress::begin(Step step, std::size_t total) {
    const std::scoped_lock lock(m_mutex);
    m_state = {step, 0, total, {}, 0.0};
    m_begun = 0;
    m_since = Clock::now();
}

bool PassProgress::next(std::string_view pass) {
    {
        const std::scoped_lock lock(m_mutex);
        m_state.done = std::min(m_begun++, m_state.total);
        m_state.pass = pass;
        m_since = Clock::now();
    }
    if (m_listener)
        m_listener(state());
    return !m_is_cancelled;
}

PassProgress::State PassProgress::state() const {
    const std::scoped_lock lock(m_mutex);
    State state = m_state;
    state.seconds = seconds_since(m_since);
    return state;
}

std::string words_of(const PassProgress::State& state) {
    constexpr double long_seconds = 3.0;
    const auto* const step = state.step == PassProgress::Step::reading   ? "Reading"
                             : state.step == PassProgress::Step::linking ? "Linking"
                                                                         : "First draws";
    if (state.total == 0)
        return step;
    const std::string slow =
        state.seconds > long_seconds ? fmt::format(", '{}' takes long", state.pass) : std::string();
    return fmt::format("{}: {} of {} passes{}", step, state.done, state.total, slow);
}
