#include "lab/flash_meter.h"

Result<FlashMeter> FlashMeter::make() {
    auto cells = LightCells::make();
    if (!cells)
        return fail(cells.error());
    return FlashMeter(std::move(*cells));
}

void FlashMeter::update(const gpu::Texture& picture, Encoding encoding, double seconds) {
    while (!m_coming.empty() && m_coming.front().cells.has_come()) {
        Coming& first = m_coming.front();
        m_flashes = m_counter.add(first.seconds, taken_cells(first.cells));
        m_coming.pop_front();
    }
    constexpr std::size_t most_coming = 6;  // a GPU that is further behind is not asked for more
    if (m_coming.size() < most_coming && m_cells.draw(picture, encoding))
        m_coming.push_back({seconds, gpu::Download(m_cells.canvas())});
}

void FlashMeter::stop() {
    m_coming.clear();
    m_counter = {};
    m_flashes = {};
}
