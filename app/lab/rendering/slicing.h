#pragma once

/// Whether frames are drawn in slices: those of a look that would keep a window from answering, and
/// a first one, of which nothing is known yet.
class Slicing {
public:
    /// Of a window's turn; 0: all frames are drawn whole.
    void set_slice(double seconds) { m_slice_seconds = seconds; }
    double slice_seconds() const { return m_slice_seconds; }
    bool is_due() const { return m_slice_seconds > 0.0 && m_weight != Weight::light; }
    /// What drawing a frame took: one of more than one and a half slices is heavy, one of less than
    /// a slice light, between them all stays as it was.
    void note(double seconds);
    /// Each frame is known to take long.
    bool is_heavy() const { return m_weight == Weight::heavy; }
    /// What is drawn is another look.
    void forget() { m_weight = Weight::unknown; }

private:
    enum class Weight { unknown, light, heavy };

    double m_slice_seconds = 0.0;
    Weight m_weight = Weight::unknown;
};
