#pragma once

/// Decides whether frames are drawn in slices: those of a look that would block the window, and the
/// first one, which has an unknown cost.
class Slicing {
public:
    /// The time of a slice per update of the window; 0: all frames are drawn whole.
    void set_slice(double seconds) { m_slice_seconds = seconds; }
    double slice_seconds() const { return m_slice_seconds; }
    bool is_due() const { return m_slice_seconds > 0.0 && m_weight != Weight::light; }
    /// Records the time of a frame. More than 1.5 slices is heavy, less than one slice is light. In
    /// between the weight does not change.
    void note(double seconds);
    /// Whether frames are known to be slow.
    bool is_heavy() const { return m_weight == Weight::heavy; }
    /// Call when another look is drawn.
    void forget() { m_weight = Weight::unknown; }

private:
    enum class Weight { unknown, light, heavy };

    double m_slice_seconds = 0.0;
    Weight m_weight = Weight::unknown;
};
