#pragma once

#include "lab/storage/event_waker.h"

#include <optional>

class Lab;
class OscControl;

/// Wakes the window when a watched file changes, or a MIDI or OSC message arrives.
class LabWakers {
public:
    explicit LabWakers(Lab& lab);

    /// Follows a change of the OSC port. Call it in every update.
    void update(const OscControl& osc);

private:
    EventWaker m_files;
    EventWaker m_midi;
    std::optional<EventWaker> m_osc;  // while other programs can set parameters
    std::size_t m_osc_opening = 0;
};
