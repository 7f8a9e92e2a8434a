#include "model/picture/subframe_cells.h"

#include <utility>

std::optional<std::vector<Light>> SubframeCells::add(const Subframe& subframe,
                                                     std::span<const Light> cells) {
    if (subframe.is_first()) {
        m_sum.assign(cells.size(), Light{});
        m_next = subframe;
    }
    if (subframe != m_next || cells.size() != m_sum.size()) {
        m_next = {};
        m_sum.clear();
        return std::nullopt;
    }
    ++m_next.index;
    const auto share = 1.0f / static_cast<float>(subframe.count);
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (std::size_t c = 0; c < cells[i].size(); ++c)
            m_sum[i][c] += share * cells[i][c];
    if (m_next.index < subframe.count)
        return std::nullopt;
    return std::exchange(m_sum, {});
}
