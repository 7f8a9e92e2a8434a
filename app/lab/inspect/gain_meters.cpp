#include "lab/inspect/gain_meters.h"

#include "base/elapsed.h"

#include <chrono>

void LevelMeters::stop() {
    m_meter.stop();
    m_passes.clear();
    m_gains.clear();
    m_round_robin.restart(0);
}

void LevelMeters::take_answer() {
    if (const auto measured = m_meter.take(); measured && m_asked < m_gains.size())
        m_gains[m_asked] = target_level_of(measured->statistics, measured->clipped, m_ceiling);
}

void LevelMeters::update(const Executor& executor, const Values& values, double seconds) {
    const Look& look = executor.look();
    if (m_passes != pass_names(look)) {
        stop();  // discard gains of another look
        m_passes = pass_names(look);
        m_gains.resize(m_passes.size());
        m_round_robin.restart(m_passes.size());
    }
    take_answer();
    const auto due = m_round_robin.due(executor.textures().number(), seconds);
    if (m_meter.is_busy() || !due)
        return;
    m_asked = *due;
    m_ceiling = ceiling_of(look, m_asked, values);
    const auto start = std::chrono::steady_clock::now();
    m_meter.start(executor.target(static_cast<int>(m_asked)), Channels::color,
                  clips_from(m_ceiling));
    m_round_robin.done(seconds, seconds_since(start));
}

const TargetLevel* LevelMeters::gain(std::size_t pass) const {
    return pass < m_gains.size() && m_gains[pass] ? &*m_gains[pass] : nullptr;
}
