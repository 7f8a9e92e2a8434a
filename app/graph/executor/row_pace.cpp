#include "graph/executor/row_pace.h"

#include <algorithm>

int RowPace::rows_for(double seconds, int left) const {
    constexpr int fewest = 2;
    constexpr int growth = 8;  // the next rows may take longer
    if (m_rows == 0)
        return std::min(fewest, left);
    const double maximum = std::min(left, growth * m_rows);
    const double fit =
        std::clamp(seconds / std::max({m_seconds_per_row, m_usual_seconds, 1e-9}), 0.0, maximum);
    const int even = std::max(static_cast<int>(fit) / 2 * 2, fewest);
    return even >= left - 1 ? left : even;
}

void RowPace::note(int rows, double seconds) {
    m_rows = rows;
    m_seconds_per_row = seconds / rows;
    m_drawn_rows += rows;
    m_drawn_seconds += seconds;
}

void RowPace::end_draw() {
    m_usual_seconds = m_drawn_rows > 0 ? m_drawn_seconds / m_drawn_rows : 0.0;
    m_drawn_rows = 0;
    m_drawn_seconds = 0.0;
}
