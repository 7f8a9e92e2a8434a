#pragma once

/// Estimates how many rows of a pass fit into a time limit. Uses the previous band and the whole
/// previous draw, because some rows take longer than others.
class RowPace {
public:
    /// The number of rows, at most `left`, that take about `seconds`. Even, as the GPU draws rows
    /// in pairs.
    int rows_for(double seconds, int left) const;
    void note(int rows, double seconds);
    /// Call after the last row of a draw.
    void end_draw();

private:
    int m_rows = 0;                  // of the latest band; 0: no band yet
    double m_seconds_per_row = 0.0;  // of the latest band
    int m_drawn_rows = 0;            // of this draw
    double m_drawn_seconds = 0.0;    // time of these rows
    double m_usual_seconds = 0.0;    // per row, of the whole previous draw
};
