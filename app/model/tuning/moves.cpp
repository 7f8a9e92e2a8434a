#include "model/tuning/moves.h"

#include <algorithm>

namespace {
constexpr double slack = 1e-6;  // s, the resolution of a file

bool is_reserved_later(double seconds, const Move& move) {
    return seconds + slack < move.seconds;
}

// Searches the moves at the end of the list.
Move* find_at(Moves& moves, double seconds, const std::string& name) {
    for (auto move = moves.rbegin(); move != moves.rend() && move->seconds == seconds; ++move)
        if (move->name == name)
            return &*move;
    return nullptr;
}
}  // namespace

bool is_recorded(const Parameter& parameter) {
    return parameter.control != Control::image && parameter.control != Control::sound;
}

bool MovesReader::has(const std::string& name) const {
    return std::ranges::find(m_moves, name, &Move::name) != m_moves.end();
}

Values MovesReader::take(double seconds) {
    Values values;
    for (; m_next < m_moves.size() && !is_reserved_later(seconds, m_moves[m_next]); ++m_next)
        values[m_moves[m_next].name] = m_moves[m_next].value;
    return values;
}

void MovesRecorder::go_back(double seconds) {
    m_moves.erase(std::ranges::upper_bound(m_moves, seconds, {}, &Move::seconds), m_moves.end());
    m_last.clear();
    for (const Move& move : m_moves)
        m_last[move.name] = move.value;
}

void MovesRecorder::start(Look look, const Values& values) {
    m_look = std::move(look);
    m_is_running = true;
    m_last.clear();
    m_moves.clear();
    note(values, 0.0);
}

void MovesRecorder::note(const Values& values, double seconds) {
    if (!m_is_running)
        return;
    if (!m_moves.empty() && is_reserved_later(seconds, m_moves.back()))
        go_back(seconds);
    if (values == m_last)
        return;
    for (const Parameter& parameter : m_look.parameters) {
        const Value& now = value_of(parameter, values);
        if (!is_recorded(parameter) || now == value_of(parameter, m_last))
            continue;
        if (Move* same = find_at(m_moves, seconds, parameter.name))
            same->value = now;  // changed again at the same time
        else
            m_moves.push_back({seconds, parameter.name, now});
    }
    m_last = values;
}
