#pragma once

#include "graph/executor/executor.h"
#include "graph/inspect/meter.h"
#include "lab/inspect/round_robin.h"
#include "model/picture/gain.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

/// The levels of all passes of the open look, measured one pass at a time.
class LevelMeters {
public:
    explicit LevelMeters(std::shared_ptr<const MeterPrograms> programs)
        : m_meter(std::move(programs)) {}

    /// Call it in every update while the meters are visible. Never waits for the GPU.
    void update(const Executor& executor, const Values& values, double seconds);
    /// Discards all gains; call it when the meters are hidden.
    void stop();

    /// Whether some passes have not been measured since the last change.
    bool is_pending() const { return m_round_robin.is_pending() || m_meter.is_busy(); }
    /// Null: not measured yet.
    const TargetLevel* gain(std::size_t pass) const;

private:
    void take_answer();

    Meter m_meter;
    std::vector<std::string> m_passes;                // to detect another look
    std::vector<std::optional<TargetLevel>> m_gains;  // of each pass
    std::size_t m_asked = 0;                          // the pass being measured
    double m_ceiling = 1.0;                           // of that pass
    RoundRobin m_round_robin;
};
