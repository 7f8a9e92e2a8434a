#pragma once

/// How many rows of a pass are drawn at once, so that somebody who draws it in bands is back in
/// time. Learns from the band before, and from the whole of the draw before: some rows take longer
/// than others.
class RowPace {
public:
    /// Of `left` rows, those that take about `seconds`; even, as the GPU draws them in pairs.
    int rows_for(double seconds, int left) const;
    void note(int rows, double seconds);
    /// All rows were drawn.
    void end_draw();

private:
    int m_rows = 0;                // of the latest band; 0: there was none
    double m_seconds_a_row = 0.0;  // of it
    int m_drawn_rows = 0;          // of this draw
    double m_drawn_seconds = 0.0;  // that these took
    double m_usual_seconds = 0.0;  // a row, of the whole draw before
};
