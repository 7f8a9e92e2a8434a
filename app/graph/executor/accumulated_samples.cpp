#include "graph/executor/accumulated_samples.h"

#include <algorithm>

void AccumulatedSamples::restart() {
    m_held.assign(m_graph.look().passes.size(), 0);
}

bool AccumulatedSamples::restart(const std::vector<bool>& changed) {
    const std::vector<bool> reached = dependents_of(m_graph.look(), changed);
    m_held.resize(reached.size());
    for (std::size_t i = 0; i < reached.size(); ++i)
        if (reached[i])
            m_held[i] = 0;
    return std::ranges::find(reached, true) != reached.end();
}

std::optional<Samples> AccumulatedSamples::last() const {
    for (std::size_t i = m_graph.look().passes.size(); i-- > 0;)
        if (m_graph.look().passes[i].accumulate)
            return Samples{held(i), m_graph.samples_to_converge(i)};
    return std::nullopt;
}

int AccumulatedSamples::before(std::size_t pass) const {
    while (pass-- > 0)
        if (m_graph.look().passes[pass].accumulate)
            return held(pass);
    return 0;
}

bool AccumulatedSamples::has_converged(std::size_t pass) const {
    const int enough = m_graph.samples_to_converge(pass).value_or(0);
    return enough > 0 && held(pass) >= enough;
}

int AccumulatedSamples::begin_frame(std::size_t pass, double sample_budget_seconds,
                                    double seconds_each) {
    const auto enough = m_graph.samples_to_converge(pass);
    if (enough == 0)
        m_held[pass] = 0;
    int due = m_graph.repeats_of(pass);
    if (enough.value_or(0) > 0)
        due = std::min(due, std::max(0, *enough - m_held[pass]));
    if (sample_budget_seconds <= 0.0 || due <= 1)
        return due;
    if (seconds_each <= 0.0)
        return 1;
    const double maximum = due;
    return static_cast<int>(std::clamp(sample_budget_seconds / seconds_each, 1.0, maximum));
}

void AccumulatedSamples::note_frame() {
    m_held.resize(m_graph.look().passes.size());
    m_whole = m_held;
}

void AccumulatedSamples::drop_frame(bool is_picture_lost) {
    if (is_picture_lost)
        restart();
    else
        m_held = m_whole;
}
