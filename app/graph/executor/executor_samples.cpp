// The part of Executor for accumulating passes.
#include "graph/executor/executor.h"

#include <algorithm>

// Drops an unfinished frame that takes samples.
void Executor::drop_samples() {
    if (m_is_amid_frame && samples())
        drop_frame();
}

void Executor::restart_samples() {
    drop_samples();
    for (PassState& state : m_passes)
        state.samples = 0;
}

void Executor::restart_samples(const std::vector<bool>& changed_passes) {
    const std::vector<bool> reached = reached_from(m_look, changed_passes);
    if (std::ranges::find(reached, true) != reached.end())
        drop_samples();
    for (std::size_t i = 0; i < m_passes.size(); ++i)
        if (reached[i])
            m_passes[i].samples = 0;
}

void Executor::note_mouse_moved() {
    std::vector<bool> readers;
    for (const PassState& state : m_passes)
        readers.push_back(state.built_ins.tell_mouse());
    restart_samples(readers);
}

std::optional<int> Executor::enough_of(const Pass& pass) const {
    constexpr double most = 1 << 30;
    if (!pass.converge)
        return std::nullopt;
    return static_cast<int>(std::clamp(count_of(*pass.converge, m_look, m_values), 0.0, most));
}

std::optional<Samples> Executor::samples() const {
    for (std::size_t i = m_passes.size(); i-- > 0;)
        if (m_look.passes[i].accumulate)
            return Samples{m_passes[i].samples, enough_of(m_look.passes[i])};
    return std::nullopt;
}

// Of the last accumulating pass before this one.
int Executor::samples_before(std::size_t index) const {
    while (index-- > 0)
        if (m_look.passes[index].accumulate)
            return m_passes[index].samples;
    return 0;
}

bool Executor::has_converged() const {
    if (m_look.driven_by == Driver::signal || m_targets.size() != m_passes.size() || !samples())
        return false;
    for (std::size_t i = 0; i < m_passes.size(); ++i)
        if (!rests(i))
            return false;
    return true;
}

// With a time limit, only the samples that fit. The time of a sample is known after the first ones.
int Executor::samples_due(std::size_t index) const {
    const Pass& pass = m_look.passes[index];
    const PassState& state = m_passes[index];
    int due = repeats_of(pass);
    if (const int enough = enough_of(pass).value_or(0); enough > 0)
        due = std::min(due, std::max(0, enough - state.samples));
    if (m_drawn.patience_seconds <= 0.0 || due <= 1)
        return due;
    const double each = state.timer->milliseconds_a_part().value_or(0.0) / 1000.0;
    if (each <= 0.0)
        return 1;
    const double most = due;
    return static_cast<int>(std::clamp(m_drawn.patience_seconds / each, 1.0, most));
}

// The number of samples in this frame. Without any, the picture so far stays.
void Executor::count_samples(std::size_t index) {
    PassState& state = m_passes[index];
    Target& target = m_targets[index];
    if (enough_of(m_look.passes[index]) == 0)
        state.samples = 0;
    m_work.draws = samples_due(index);
    if (m_work.draws == 0 && target.has_former())
        target.canvas(1).copy_to(target.canvas());
}
