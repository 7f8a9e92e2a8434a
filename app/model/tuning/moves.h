#pragma once

#include "model/look/look.h"

#include <string>
#include <vector>

/// A change of a parameter: its value from this time.
struct Move {
    double seconds = 0.0;  // on the clock of the picture
    std::string name;
    Value value;

    bool operator==(const Move&) const = default;
};

/// In order of time.
using Moves = std::vector<Move>;

/// Whether changes of the parameter are recorded: all except files.
bool is_recorded(const Parameter& parameter);

/// Reads moves in order of time.
class MovesReader {
public:
    explicit MovesReader(Moves moves = {}) : m_moves(std::move(moves)) {}

    bool is_empty() const { return m_moves.empty(); }
    /// Whether a move changes the parameter.
    bool has(const std::string& name) const;
    /// The values since the last call: for each parameter the last one at or before this time,
    /// within a file's resolution of 1 us.
    Values take(double seconds);
    void start_again() { m_next = 0; }

private:
    Moves m_moves;
    std::size_t m_next = 0;
};

/// Records changes of parameters.
class MovesRecorder {
public:
    /// Starts recording. Values that differ from the defaults are recorded at time 0, so that the
    /// moves are complete. Simultaneous changes are in the order of the look.
    void start(Look look, const Values& values);
    bool is_running() const { return m_is_running; }
    void stop() { m_is_running = false; }

    /// Records the values of the frame that ends at this time. If the clock has gone back, later
    /// moves are replaced.
    void note(const Values& values, double seconds);
    const Moves& moves() const { return m_moves; }
    /// The look at the start.
    const Look& look() const { return m_look; }

private:
    void go_back(double seconds);

    bool m_is_running = false;
    Look m_look;
    Values m_last;
    Moves m_moves;
};
