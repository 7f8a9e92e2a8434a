#include "model/tuning/cue_plan.h"

#include "model/tuning/morph.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr double cue_slack = 1e-6;  // s, the resolution of a file

bool cue_has_begun(const CueAction& action, double position) {
    return action.seconds <= position + cue_slack;
}

double cue_share(const CueAction& action, double position) {
    const double since = position - action.seconds;
    return action.over > 0.0 ? std::clamp(since / action.over, 0.0, 1.0) : 1.0;
}
}  // namespace

CuePlan::CuePlan(std::vector<CueAction> actions) : m_actions(std::move(actions)) {
    std::ranges::stable_sort(m_actions, {}, &CueAction::seconds);
    for (const CueAction& action : m_actions)
        for (const auto& [name, value] : action.values)
            m_changed.insert(name);
}

bool CuePlan::changes(const std::string& parameter) const {
    return m_changed.contains(parameter);
}

// The last of the first `count` cues that changes the parameter defines it. While it changes, it
// starts at the value that the earlier ones gave at its time.
Value CuePlan::value_at(const Parameter& parameter, const Value& without, double position,
                        std::size_t count) const {
    std::vector<std::size_t> running;  // cues whose change has not ended, the latest first
    const Value* start = &without;
    for (std::size_t i = count; i-- > 0;) {
        const CueAction& action = m_actions[i];
        const auto goal = action.values.find(parameter.name);
        const double at = running.empty() ? position : m_actions[running.back()].seconds;
        if (goal == action.values.end() || !cue_has_begun(action, at))
            continue;
        if (cue_share(action, at) >= 1.0) {
            start = &goal->second;
            break;
        }
        running.push_back(i);
    }
    Value value = *start;
    for (std::size_t i = running.size(); i-- > 0;) {
        const CueAction& action = m_actions[running[i]];
        const double at = i == 0 ? position : m_actions[running[i - 1]].seconds;
        value = morphed_value(parameter, value, action.values.at(parameter.name),
                              cue_share(action, at));
    }
    return value;
}

CuedState CuePlan::state_at(const Look& look, const CuedState& without, double position) const {
    CuedState state = without;
    for (const Parameter& parameter : look.parameters)
        if (changes(parameter.name))
            state.values[parameter.name] = value_at(parameter, value_of(parameter, without.values),
                                                    position, m_actions.size());
    for (const CueAction& action : m_actions)
        if (action.modulations && cue_has_begun(action, position - action.over))
            state.modulations = *action.modulations;
    return state;
}

bool CuePlan::is_black_at(double position) const {
    bool is_black = false;
    for (const CueAction& action : m_actions)
        if (action.kind == CueAction::Kind::blackout && cue_has_begun(action, position))
            is_black = action.is_on;
    return is_black;
}

bool CuePlan::restarts_within(double from, double to, double loop_start, double loop_end) const {
    return std::ranges::any_of(m_actions, [&](const CueAction& action) {
        if (action.kind != CueAction::Kind::restart)
            return false;
        const bool is_after = !cue_has_begun(action, from);
        const bool is_before = cue_has_begun(action, to);
        if (to >= from)
            return is_after && is_before;
        return (is_after && action.seconds < loop_end) ||
               (is_before && action.seconds + cue_slack >= loop_start);
    });
}

std::string cue_refusal(const Parameter& parameter) {
    const std::string& name = parameter.name;
    if (parameter.control == Control::event)
        return fmt::format("'{}' can't be used in a cue: it is a button", name);
    if (parameter.control == Control::image || parameter.control == Control::sound)
        return fmt::format("'{}' can't be used in a cue: it is a file", name);
    if (parameter.is_constant)
        return fmt::format("'{}' can't be used in a cue: changing it recompiles the look", name);
    return "";
}
