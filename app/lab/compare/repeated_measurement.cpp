#include "lab/compare/repeated_measurement.h"

#include "base/elapsed.h"

#include <algorithm>
#include <chrono>
#include <utility>

Result<RepeatedMeasurement> RepeatedMeasurement::make() {
    auto meter = PairMeter::make();
    if (!meter)
        return fail(meter.error());
    return RepeatedMeasurement(std::move(*meter));
}

void RepeatedMeasurement::update(double seconds, const std::function<void(PairMeter&)>& start) {
    constexpr double pause_seconds = 0.2;
    constexpr double max_share = 0.1;  // of the time
    const auto measured = m_meter.take();
    if (measured && (measured->distances || measured->luminances))
        m_latest = *measured;
    if (m_meter.is_busy() || (m_due && seconds < *m_due))
        return;
    const auto begun = std::chrono::steady_clock::now();
    start(m_meter);
    m_due = seconds + std::max(pause_seconds, seconds_since(begun) / max_share);
}

void RepeatedMeasurement::stop() {
    m_meter.stop();
    m_latest = {};
    m_due.reset();
}
