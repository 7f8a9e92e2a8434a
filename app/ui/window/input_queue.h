#pragma once

#include "gpu/input_event.h"

#include <deque>
#include <set>
#include <vector>

/// Hands out what mouse and keyboard did in portions that one frame can answer. A widget looks once
/// a frame at what is down and where the pointer is, so a click that came and went within a slow
/// frame, or two clicks at two places, would be lost or land in the wrong place. Here nothing is:
/// what a frame cannot see beside the events before it waits for the next.
class InputQueue {
public:
    void add(const std::vector<gpu::InputEvent>& events);
    /// The events of the next frame, in order. `is_typing`: a text field takes what is printed.
    std::vector<gpu::InputEvent> take_frame(bool is_typing);
    bool is_empty() const { return m_waiting.empty(); }

private:
    struct Seen;  // what the frame has been given so far

    bool fits(const gpu::InputEvent& event, const Seen& seen) const;
    void note(const gpu::InputEvent& event, Seen& seen);

    std::deque<gpu::InputEvent> m_waiting;
    gpu::PointerEvent m_pointer;
    std::set<int> m_modifiers;   // down after what was handed out
    int m_frames_to_settle = 0;  // until a text field that was asked for takes text
};
