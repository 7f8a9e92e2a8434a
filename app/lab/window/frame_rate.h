#pragma once

/// The frame rate limit of the window, and the time budget of a frame.
struct FrameRate {
    static constexpr double no_cap = 1000.0;

    bool waits_for_display = true;               // vertical synchronisation
    double cap = 0.0;                            // frames/s; 0: the display's refresh rate
    double budget_milliseconds = 1000.0 / 60.0;  // GPU time budget of all passes

    bool operator==(const FrameRate&) const = default;
    /// The minimum seconds between frames for this refresh rate of the display.
    double frame_seconds(double display_rate) const;
    /// Whether the target is more than 30 frames/s.
    bool wants_30(double display_rate) const { return frame_seconds(display_rate) < 1.0 / 31.0; }
};
