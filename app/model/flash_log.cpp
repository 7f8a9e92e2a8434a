#include "model/flash_log.h"

#include "model/color.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
constexpr int places = 8;  // in a row of a cell

float light_of(float stored, Encoding encoding) {
    if (!(stored > 0.0f))  // NaN too
        return 0.0f;
    const double number = std::min(static_cast<double>(stored), 1.0);
    return static_cast<float>(encoding == Encoding::display ? srgb_decode(number) : number);
}
}  // namespace

std::vector<Light> cells_of(const Picture& picture) {
    std::vector<Light> cells(static_cast<std::size_t>(flash_cells.width * flash_cells.height));
    if (picture.extent.is_empty())
        return cells;
    const auto channels = static_cast<std::size_t>(picture.channels);
    const int columns = flash_cells.width * places;
    const int rows = flash_cells.height * places;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int x = (2 * column + 1) * picture.extent.width / (2 * columns);
            const int y = (2 * row + 1) * picture.extent.height / (2 * rows);
            const float* pixel =
                &picture.pixels[static_cast<std::size_t>(y * picture.extent.width + x) * channels];
            Light& cell =
                cells[static_cast<std::size_t>(row / places * flash_cells.width + column / places)];
            for (std::size_t i = 0; i < 3; ++i)
                cell[i] += light_of(pixel[channels >= 3 ? i : 0], picture.encoding) /
                           static_cast<float>(places * places);
        }
    return cells;
}

void FlashLog::add(const Picture& picture, double seconds) {
    const Flashes now = m_counter.add(seconds, cells_of(picture));
    m_most = {std::max(m_most.general, now.general), std::max(m_most.red, now.red)};
    if (!now.is_beyond_limit())
        return;
    if (!m_first)
        m_first = seconds;
    m_last = seconds;
    ++m_count;
}

std::optional<std::string> FlashLog::warning() const {
    if (!m_first)
        return std::nullopt;
    return fmt::format(
        "the picture flashes up to {} times a second ({} in red), more than the {} of WCAG 2.3.1: "
        "{} frames from {:.2f} s to {:.2f} s",
        m_most.most(), m_most.red, Flashes::limit, m_count, *m_first, m_last);
}
