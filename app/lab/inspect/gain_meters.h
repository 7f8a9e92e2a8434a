#pragma once

#include "graph/executor/executor.h"
#include "graph/inspect/meter.h"
#include "lab/inspect/rota.h"
#include "model/picture/gain.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

/// How loud every pass of the open look is: one pass in turn is measured.
class GainMeters {
public:
    explicit GainMeters(std::shared_ptr<const MeterPrograms> programs)
        : m_meter(std::move(programs)) {}

    /// To be called every turn while the meters are shown; never waits for the GPU.
    void update(const Executor& executor, const Values& values, double seconds);
    /// Nobody looks any more.
    void stop();

    /// Some passes have not been measured as they are now.
    bool is_owing() const { return m_rota.is_owing() || m_meter.is_busy(); }
    /// Null until it has come.
    const Gain* gain(std::size_t pass) const;

private:
    void take_answer();

    Meter m_meter;
    std::vector<std::string> m_passes;         // names: another look has other gains
    std::vector<std::optional<Gain>> m_gains;  // of each pass
    std::size_t m_asked = 0;                   // that is being measured
    double m_ceiling = 1.0;                    // of it
    Rota m_rota;
};
