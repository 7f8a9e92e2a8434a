#pragma once

#include "gpu/input_event.h"

#include <deque>
#include <set>
#include <vector>

/// Splits mouse and keyboard events into portions that a single frame can process. Widgets only
/// read the current button and pointer state once per frame. A click within a slow frame would be
/// lost, and one of two clicks would have the wrong position. Events that conflict with earlier
/// ones in the frame wait for the next frame.
class InputQueue {
public:
    void add(const std::vector<gpu::InputEvent>& events);
    /// The events of the next frame, in order. `is_typing`: a text field receives printed
    /// characters.
    std::vector<gpu::InputEvent> take_frame(bool is_typing);
    bool is_empty() const { return m_waiting.empty(); }

private:
    struct Seen;  // the events of this frame so far

    bool fits(const gpu::InputEvent& event, const Seen& seen) const;
    void note(const gpu::InputEvent& event, Seen& seen);

    std::deque<gpu::InputEvent> m_waiting;
    gpu::PointerEvent m_pointer;
    std::set<int> m_modifiers;   // after the returned events
    int m_frames_to_settle = 0;  // until a new text field accepts text
};
