#pragma once

#include "graph/executor/executor.h"
#include "graph/inspect/point_reader.h"

#include <string>
#include <vector>

/// The readouts of a look, read at most five times a second.
class Readouts {
public:
    static Result<Readouts> make();

    /// Call it in every update. Never waits for the GPU.
    void update(const Executor& executor, double seconds);
    /// Call it when the look is no longer drawn.
    void stop();

    /// One text per readout, in the order of the passes; empty: none, or still pending.
    const std::vector<std::string>& texts() const { return m_texts; }

private:
    explicit Readouts(PointReader reader) : m_reader(std::move(reader)) {}

    PointReader m_reader;
    std::vector<Readout> m_readouts;  // of the last request
    std::vector<std::string> m_texts;
    double m_due = 0.0;  // s
};
