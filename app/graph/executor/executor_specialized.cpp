// The part of Executor that draws with specialised programs.
#include "graph/executor/executor.h"

#include <algorithm>
#include <utility>

// Timings and samples belong to the pass, whichever program draws it.
void Executor::move_state(std::vector<PassState>& from) {
    for (std::size_t i = 0; i < m_passes.size(); ++i) {
        std::swap(m_passes[i].timer, from[i].timer);
        m_passes[i].pace = from[i].pace;
        m_passes[i].samples = from[i].samples;
        m_passes[i].whole_samples = from[i].whole_samples;
    }
}

void Executor::specialize(Programs programs, std::set<std::string> moving) {
    const gpu::ContextScope scope(m_home.get());
    drop_frame();
    end_specialized();
    m_unsettled.emplace(Unsettled{std::exchange(m_programs, std::move(programs)),
                                  std::exchange(m_passes, {}), std::move(m_parameters),
                                  std::move(moving)});
    std::vector<PassState> old = std::exchange(m_specialized_passes, {});
    for (std::size_t i = 0; i < m_look.passes.size(); ++i) {
        const bool serves = i < old.size() && old[i].program == m_programs.passes[i].program;
        m_passes.push_back(serves ? std::move(old[i]) : make_state(i));
    }
    move_state(m_unsettled->passes);
    m_parameters = ParameterUniforms(m_look, m_programs);
    m_parameters.write(m_look, m_values);
}

// Restores the generic programs. Their uniforms are not written yet.
void Executor::take_own_back() {
    Unsettled own = std::move(*std::exchange(m_unsettled, std::nullopt));
    m_specialized_passes = std::exchange(m_passes, std::move(own.passes));
    move_state(m_specialized_passes);
    m_programs = std::move(own.programs);
    m_parameters = std::move(own.parameters);
    m_parameters.forget_written();  // other executors may have written to them
}

void Executor::end_specialized() {
    if (!m_unsettled)
        return;
    drop_frame();
    take_own_back();
    m_parameters.write(m_look, m_values);
}

void Executor::end_specialized_if_moved(const std::vector<std::string>& changed) {
    const auto holds = [this](const std::string& name) {
        return !m_unsettled->moving.contains(name);
    };
    if (m_unsettled && std::ranges::any_of(changed, holds))
        end_specialized();
}
