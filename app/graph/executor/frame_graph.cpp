#include "graph/executor/frame_graph.h"

#include "model/look/value_changes.h"

#include <algorithm>
#include <utility>

PlanTerms FrameGraph::terms(const FrameSettings& settings, const Look& look) const {
    PlanTerms terms{.largest_side = m_largest_side,
                    .seen = settings.displayed,
                    .draws_once = settings.redraws == Redraws::never};
    if (!terms.seen.empty())
        terms.seen.resize(look.passes.size(), true);
    for (std::size_t i = 0; i < look.passes.size(); ++i) {
        const PassRun run = i < settings.runs.size() ? settings.runs[i] : PassRun::drawn;
        terms.kept.push_back(run != PassRun::drawn || look.passes[i].per_source_frame);
        terms.left_out.push_back(run == PassRun::left_out);
    }
    return terms;
}

Result<Plan> FrameGraph::plan_for(const FrameSettings& settings) const {
    PlanTerms conditions = terms(settings, m_look);
    conditions.read = m_read_inputs;
    return plan_targets(m_look, settings.viewport, settings.source, m_values, conditions);
}

// Which inputs the programs of the edited look read is not known yet.
Result<Plan> FrameGraph::plan_for(const Look& edited) const {
    PlanTerms conditions = terms(m_settings, edited);
    if (pass_names(edited) != pass_names(m_look))
        conditions.seen.clear();
    return plan_targets(edited, m_settings.viewport, m_settings.source, m_values, conditions);
}

std::vector<std::string> FrameGraph::set_values(const Values& values) {
    std::vector<std::string> changed = changed_parameters(m_look, m_values, values);
    follow_values(m_values, values);
    if (!changed.empty())
        m_spots.clear();
    return changed;
}

void FrameGraph::set_settings(FrameSettings settings) {
    m_settings = std::move(settings);
    m_spots.clear();
}

void FrameGraph::set_plan(Plan plan) {
    m_plan = std::move(plan);
    m_order = draw_order(m_plan);
    m_spots.clear();
}

void FrameGraph::set_look(Look look) {
    if (pass_names(look) != pass_names(m_look))
        m_settings.displayed.clear();
    m_look = std::move(look);
    m_spots.clear();
}

PassRun FrameGraph::run_of(std::size_t pass) const {
    return pass < m_settings.runs.size() ? m_settings.runs[pass] : PassRun::drawn;
}

bool FrameGraph::is_followed_onto(std::size_t pass) const {
    const auto found = std::ranges::find(m_order, pass);
    return found != m_order.end() && found + 1 != m_order.end() &&
           host_of(found[1]) == host_of(pass);
}

int FrameGraph::repeats_of(std::size_t pass) const {
    constexpr double maximum = 4096;
    return static_cast<int>(
        std::clamp(count_of(m_look.passes[pass].repeat, m_look, m_values), 1.0, maximum));
}

std::optional<int> FrameGraph::samples_to_converge(std::size_t pass) const {
    constexpr double maximum = 1 << 30;
    const auto& converge = m_look.passes[pass].converge;
    if (!converge)
        return std::nullopt;
    return static_cast<int>(std::clamp(count_of(*converge, m_look, m_values), 0.0, maximum));
}

const BeamSpot& FrameGraph::spot_of(std::size_t pass) const {
    m_spots.resize(m_look.passes.size());
    auto& spot = m_spots[pass];
    if (!spot)
        spot = ::spot_of(m_look, m_look.passes[pass], m_settings.viewport,
                         m_plan.targets[pass].extent, m_values)
                   .value_or(BeamSpot{});
    return *spot;
}

bool FrameGraph::is_read_later(std::size_t pass) const {
    return m_plan.targets[pass].slots > 1 || m_look.passes[pass].accumulate;
}

bool FrameGraph::is_overwritten(std::size_t pass) const {
    const PlannedTarget& target = m_plan.targets[pass];
    return target.common && target.slots == 1 && target.last_reader != m_order.back();
}
