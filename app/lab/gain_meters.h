#pragma once

#include "graph/executor.h"
#include "graph/meter.h"
#include "model/gain.h"

#include <optional>
#include <vector>

/// How loud every pass of the open look is: one pass in turn is measured five times a second.
class GainMeters {
public:
    static Result<GainMeters> make();

    /// To be called every turn while the meters are shown; never waits for the GPU. While nothing
    /// moves every pass is measured once more, one a turn.
    void update(const Executor& executor, const Values& values, bool is_moving, double seconds);
    /// Nobody looks any more.
    void stop();

    /// Null until it has come.
    const Gain* gain(std::size_t pass) const;

private:
    explicit GainMeters(Meter meter) : m_meter(std::move(meter)) {}
    void take_answer();

    Meter m_meter;
    std::vector<std::string> m_passes;         // names: another look has other gains
    std::vector<std::optional<Gain>> m_gains;  // of each pass
    std::size_t m_next = 0;                    // that is measured next
    std::size_t m_asked = 0;                   // that is being measured
    double m_ceiling = 1.0;                    // of it
    std::size_t m_owed = 0;                    // passes to be measured of a picture that rests
    double m_due = 0.0;                        // s
};
