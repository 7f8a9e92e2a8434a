#pragma once

#include "lab/frame/workspace.h"

#include <optional>

/// Steps one frame back, and scrubs while a bar is dragged.
class Scrubber {
public:
    explicit Scrubber(Workspace& work) : m_work(work) {}

    /// Pauses one frame earlier. All frames since the restart or the last scrub are replayed with
    /// the current values, so the picture is the same as if playback had stopped there. Live input
    /// and the mouse are not recorded. Escape cancels; then only the latest frames are replayed.
    void step_back();
    /// Seeks on the clock. A paused picture is drawn again with its afterglow.
    void scrub(double seconds);
    /// Call it in every update. A paused picture follows as fast as the frames can be drawn.
    void update();
    bool is_busy() const { return m_wanted.has_value(); }

private:
    Workspace& m_work;
    std::optional<double> m_wanted;  // of a paused picture
};
