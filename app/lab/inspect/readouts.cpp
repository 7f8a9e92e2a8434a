#include "lab/inspect/readouts.h"

#include "model/look/readout_text.h"

Result<Readouts> Readouts::make() {
    auto reader = PointReader::make();
    if (!reader)
        return fail(reader.error());
    return Readouts(std::move(*reader));
}

void Readouts::stop() {
    m_reader.stop();
    m_readouts.clear();
    m_texts.clear();
    m_due = 0.0;
}

void Readouts::update(const Executor& executor, double seconds) {
    constexpr double pause_seconds = 0.2;
    std::vector<Readout> readouts;
    std::vector<TexelPosition> positions;
    for (std::size_t i = 0; i < executor.look().passes.size(); ++i)
        if (const auto& readout = executor.look().passes[i].readout) {
            const gpu::Texture& target = executor.target(static_cast<int>(i));
            readouts.push_back(*readout);
            positions.push_back({target, 0, target.extent().height - 1});
        }
    if (readouts != m_readouts)
        stop();
    m_readouts = std::move(readouts);
    if (const auto values = m_reader.take()) {
        m_texts.clear();
        for (std::size_t i = 0; i < m_readouts.size(); ++i)
            m_texts.push_back(readout_text(m_readouts[i], static_cast<double>((*values)[i][0])));
    }
    if (positions.empty() || m_reader.is_busy() || seconds < m_due)
        return;
    m_reader.start(positions);
    m_due = seconds + pause_seconds;
}
