#pragma once

#include <deque>

/// How often the display shows a new picture of the window, measured from the updates of the
/// window, each of which waits for the display.
class DisplayPace {
public:
    /// An update `wall_seconds` after the last one. `refresh_rate`: of the display as the system
    /// reports it, Hz. `is_moving`: each refresh should show a new picture, and the update waited
    /// for it. Otherwise, and after a second without an update, it measures anew.
    void add(double wall_seconds, double refresh_rate, bool is_moving);

    /// The measured refresh rate, Hz. The reported one until it is known, 0 before the first
    /// update.
    double refresh_rate() const;
    /// New pictures per second, over the last second; 0 until it is known.
    double pictures_per_second() const;
    /// Refreshes in the last second that showed the previous picture again.
    int drops() const;
    /// The most sub-frames with which source pictures still follow at 50 Hz or more. Slower flicker
    /// is visible, and more dangerous. 1 until the pace is known. It falls at once, and rises after
    /// a second of enough pictures.
    int most_subframes() const { return m_most_subframes; }

private:
    struct Update {
        double seconds = 0.0;
        int refreshes = 1;
        bool is_even = false;  // about as long as a refresh
    };
    void clear();
    void remove_old();
    int possible_subframes() const;

    std::deque<Update> m_updates;  // of the last second
    double m_seconds = 0.0;        // their sum
    int m_refreshes = 0;           // their sum
    double m_even_seconds = 0.0;   // sum of the even ones
    int m_even_count = 0;
    double m_phase = 0.0;     // refreshes that are not counted yet
    double m_reported = 0.0;  // Hz
    int m_most_subframes = 1;
    double m_better_seconds = 0.0;  // for which more were possible
};
