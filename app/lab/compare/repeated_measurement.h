#pragma once

#include "graph/compare/pair_meter.h"

#include <functional>
#include <optional>

/// A measurement of two pictures that is repeated at most five times a second, and for less than a
/// tenth of the time if it is slow. Nothing waits for the results.
class RepeatedMeasurement {
public:
    static Result<RepeatedMeasurement> make();

    /// Takes a result that is available, and starts the next measurement if it is due.
    void update(double seconds, const std::function<void(PairMeter&)>& start);
    /// Drops the measurement and its result. The next one starts immediately.
    void stop();
    /// Empty until available.
    const PairMeasured& latest() const { return m_latest; }

private:
    explicit RepeatedMeasurement(PairMeter meter) : m_meter(std::move(meter)) {}

    PairMeter m_meter;
    PairMeasured m_latest;
    std::optional<double> m_due;  // s; nullopt: immediately
};
