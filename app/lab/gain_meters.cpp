#include "lab/gain_meters.h"

#include "base/elapsed.h"

#include <algorithm>
#include <chrono>

namespace {
constexpr double meter_pause = 0.2;
constexpr double meter_share = 0.1;  // of the time, where measuring is slow
}  // namespace

Result<GainMeters> GainMeters::make() {
    auto meter = Meter::make();
    if (!meter)
        return fail(meter.error());
    return GainMeters(std::move(*meter));
}

void GainMeters::stop() {
    m_meter.stop();
    m_passes.clear();
    m_gains.clear();
    m_due = 0.0;
}

void GainMeters::take_answer() {
    if (const auto measured = m_meter.take(); measured && m_asked < m_gains.size())
        m_gains[m_asked] = gain_of(measured->statistics, measured->clipped, m_ceiling);
}

void GainMeters::update(const Executor& executor, const Values& values, bool is_moving,
                        double seconds) {
    const Look& look = executor.look();
    if (m_passes != pass_names(look)) {
        stop();  // those numbers were another look's
        m_passes = pass_names(look);
        m_gains.resize(m_passes.size());
        m_next = 0;
        m_owed = m_passes.size();
    }
    take_answer();
    if (is_moving)
        m_owed = m_passes.size();
    const bool is_due = is_moving ? seconds >= m_due : m_owed > 0;
    if (m_meter.is_busy() || !is_due || m_passes.empty())
        return;
    if (!is_moving)
        --m_owed;
    m_asked = m_next % m_passes.size();
    m_next = m_asked + 1;
    m_ceiling = ceiling_of(look, m_asked, values);
    const auto start = std::chrono::steady_clock::now();
    m_meter.start(executor.target(static_cast<int>(m_asked)), ChannelChoice::rgb,
                  clips_from(m_ceiling));
    m_due = seconds + std::max(meter_pause, seconds_since(start) / meter_share);
}

const Gain* GainMeters::gain(std::size_t pass) const {
    return pass < m_gains.size() && m_gains[pass] ? &*m_gains[pass] : nullptr;
}
