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

namespace {
/// The text for a step: before passes are counted, during the step, and at a slow pass.
struct StepNames {
    const char* begun;
    const char* counted;
    const char* slow;
};

StepNames names_of(PassProgress::Step step) {
    switch (step) {
        case PassProgress::Step::reading:
            return {"Reading", "Reading: {} of {} passes", "Reading: {} of {} passes ({} is slow)"};
        case PassProgress::Step::linking:
            return {"Linking", "Linking: {} of {} passes", "Linking: {} of {} passes ({} is slow)"};
        case PassProgress::Step::drawing:
            break;
    }
    return {"First frame", "First frame: {} of {} passes",
            "First frame: {} of {} passes ({} is slow)"};
}
}  // namespace

std::string to_string(const PassProgress::State& state) {
    constexpr double long_seconds = 3.0;
    const StepNames names = names_of(state.step);
    if (state.total == 0)
        return names.begun;
    if (state.seconds <= long_seconds)
        return fmt::format(fmt::runtime(names.counted), state.done, state.total);
    return fmt::format(fmt::runtime(names.slow), state.done, state.total, state.pass);
}
