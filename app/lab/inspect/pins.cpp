#include "lab/inspect/pins.h"

Result<Pins> Pins::make() {
    auto gatherer = PointReader::make();
    if (!gatherer)
        return fail(gatherer.error());
    return Pins(std::move(*gatherer));
}

void Pins::stop() {
    m_gatherer.stop();
    m_values.clear();
    m_due = 0.0;
}

void Pins::update(const Executor& executor, const std::vector<Pin>& pins, double seconds) {
    constexpr double pause_seconds = 0.2;
    const std::size_t passes = executor.look().passes.size();
    if (pins != m_pins || passes != m_passes)
        stop();  // discard values of other pins or passes
    if (auto values = m_gatherer.take())
        m_values = std::move(*values);
    if (pins.empty() || m_gatherer.is_busy() || seconds < m_due)
        return;
    std::vector<TexelPosition> positions;
    for (const Pin& pin : pins)
        for (std::size_t pass = 0; pass < passes; ++pass) {
            const gpu::Texture& target = executor.target(static_cast<int>(pass));
            const auto [x, y] = pin.texel(target.extent());
            positions.push_back({target, x, y});
        }
    m_gatherer.start(positions);
    m_pins = pins;
    m_passes = passes;
    m_due = seconds + pause_seconds;
}

const std::array<float, 4>* Pins::value(std::size_t pin, std::size_t pass) const {
    const std::size_t index = pin * m_passes + pass;
    return pass < m_passes && index < m_values.size() ? &m_values[index] : nullptr;
}
