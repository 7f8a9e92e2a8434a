#include "model/tuning/automation.h"

#include <algorithm>

namespace {
constexpr double time_slack = 1e-6;  // s, the resolution of a file

bool is_reserved_later(double seconds, const AutomationPoint& point) {
    return seconds + time_slack < point.seconds;
}

// Searches the points at the end of the list.
AutomationPoint* find_at(AutomationPoints& points, double seconds, const std::string& name) {
    for (auto point = points.rbegin(); point != points.rend() && point->seconds == seconds; ++point)
        if (point->name == name)
            return &*point;
    return nullptr;
}
}  // namespace

bool is_recorded(const Parameter& parameter) {
    return parameter.control != Control::image && parameter.control != Control::sound;
}

bool AutomationReader::has(const std::string& name) const {
    return std::ranges::find(m_points, name, &AutomationPoint::name) != m_points.end();
}

Values AutomationReader::take(double seconds) {
    Values values;
    for (; m_next < m_points.size() && !is_reserved_later(seconds, m_points[m_next]); ++m_next)
        values[m_points[m_next].name] = m_points[m_next].value;
    return values;
}

void AutomationRecorder::go_back(double seconds) {
    m_points.erase(std::ranges::upper_bound(m_points, seconds, {}, &AutomationPoint::seconds),
                   m_points.end());
    m_last.clear();
    for (const AutomationPoint& point : m_points)
        m_last[point.name] = point.value;
}

void AutomationRecorder::start(Look look, const Values& values) {
    m_look = std::move(look);
    m_is_running = true;
    m_last.clear();
    m_points.clear();
    note(values, 0.0);
}

void AutomationRecorder::note(const Values& values, double seconds) {
    if (!m_is_running)
        return;
    if (!m_points.empty() && is_reserved_later(seconds, m_points.back()))
        go_back(seconds);
    if (values == m_last)
        return;
    for (const Parameter& parameter : m_look.parameters) {
        const Value& now = value_of(parameter, values);
        if (!is_recorded(parameter) || now == value_of(parameter, m_last))
            continue;
        if (AutomationPoint* same = find_at(m_points, seconds, parameter.name))
            same->value = now;  // changed again at the same time
        else
            m_points.push_back({seconds, parameter.name, now});
    }
    m_last = values;
}
