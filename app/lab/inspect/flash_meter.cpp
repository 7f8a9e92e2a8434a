#include "lab/inspect/flash_meter.h"

void FlashMeter::update(const DisplayedFrame& frame, double seconds) {
    while (!m_coming.empty() && m_coming.front().cells.is_available()) {
        Coming& first = m_coming.front();
        if (const auto cells = m_subframes.add(first.subframe, taken_cells(first.cells)))
            m_flashes = m_counter.add(first.seconds, *cells);
        m_coming.pop_front();
    }
    constexpr std::size_t max_coming = 6 + max_subframes;  // limits the backlog of a slow GPU
    const bool has_news = frame.number != m_number || m_flashes != Flashes{};
    if (!has_news || m_coming.size() >= max_coming)
        return;
    m_number = frame.number;
    if (m_cells.draw(frame.picture, frame.encoding))
        m_coming.push_back({seconds, frame.subframe, gpu::Download(m_cells.canvas())});
}

void FlashMeter::stop() {
    m_coming.clear();
    m_subframes = {};
    m_counter = {};
    m_flashes = {};
    m_number.reset();
}
