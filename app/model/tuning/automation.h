#pragma once

#include "model/look/look.h"

#include <string>
#include <vector>

/// A recorded change of a parameter: its value from this time.
struct AutomationPoint {
    double seconds = 0.0;  // on the clock of the picture
    std::string name;
    Value value;

    bool operator==(const AutomationPoint&) const = default;
};

/// In order of time.
using AutomationPoints = std::vector<AutomationPoint>;

/// Whether changes of the parameter are recorded: all except files.
bool is_recorded(const Parameter& parameter);

/// Reads automation points in order of time.
class AutomationReader {
public:
    explicit AutomationReader(AutomationPoints points = {}) : m_points(std::move(points)) {}

    bool is_empty() const { return m_points.empty(); }
    /// Whether a point changes the parameter.
    bool has(const std::string& name) const;
    /// The values since the last call: for each parameter the last one at or before this time,
    /// within a file's resolution of 1 us.
    Values take(double seconds);
    void start_again() { m_next = 0; }

private:
    AutomationPoints m_points;
    std::size_t m_next = 0;
};

/// Records changes of parameters.
class AutomationRecorder {
public:
    /// Starts recording. Values that differ from the defaults are recorded at time 0, so that the
    /// points are complete. Simultaneous changes are in the order of the look.
    void start(Look look, const Values& values);
    bool is_running() const { return m_is_running; }
    void stop() { m_is_running = false; }

    /// Records the values of the frame that ends at this time. If the clock has gone back, later
    /// points are replaced.
    void note(const Values& values, double seconds);
    const AutomationPoints& points() const { return m_points; }
    /// The look at the start.
    const Look& look() const { return m_look; }

private:
    void go_back(double seconds);

    bool m_is_running = false;
    Look m_look;
    Values m_last;
    AutomationPoints m_points;
};
