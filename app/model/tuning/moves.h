#pragma once

#include "model/look/look.h"

#include <string>
#include <vector>

/// A parameter that was turned: from this time on it has this value.
struct Move {
    double seconds = 0.0;  // on the clock of the picture
    std::string name;
    Value value;

    bool operator==(const Move&) const = default;
};

/// By their times, the first one first.
using Moves = std::vector<Move>;

/// Whether moves tell of the parameter: of all but files.
bool is_recorded(const Parameter& parameter);

/// Goes through moves as time goes on.
class MovesReader {
public:
    explicit MovesReader(Moves moves = {}) : m_moves(std::move(moves)) {}

    bool is_empty() const { return m_moves.empty(); }
    /// Whether one of them is the parameter's.
    bool has(const std::string& name) const;
    /// The values that have come since last asked: of each parameter the last one at or before this
    /// time, to the millionth of a second that a file tells.
    Values take(double seconds);
    void start_again() { m_next = 0; }

private:
    Moves m_moves;
    std::size_t m_next = 0;
};

/// Writes down what is turned.
class MovesRecorder {
public:
    /// From here on. What differs from the defaults now is told at time 0, so that the moves say
    /// all; of two parameters that change at once the look's first comes first.
    void start(Look look, const Values& values);
    bool is_running() const { return m_is_running; }
    void stop() { m_is_running = false; }

    /// The values of the frame that ends at this time. When the clock has gone back, what was
    /// recorded after it is recorded over.
    void note(const Values& values, double seconds);
    const Moves& moves() const { return m_moves; }
    /// As it was at the start.
    const Look& look() const { return m_look; }

private:
    void go_back(double seconds);

    bool m_is_running = false;
    Look m_look;
    Values m_last;
    Moves m_moves;
};
