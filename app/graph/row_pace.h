#pragma once

/// How many rows of a pass are drawn at once, so that somebody who draws it in bands is back in
/// time. Learns from the bands before.
class RowPace {
public:
    /// Of `left` rows, those that take about `seconds`; even, as the GPU draws them in pairs.
    int rows_for(double seconds, int left) const;
    void note(int rows, double seconds);

private:
    int m_rows = 0;                // of the latest band; 0: there was none
    double m_seconds_a_row = 0.0;  // of it
};
