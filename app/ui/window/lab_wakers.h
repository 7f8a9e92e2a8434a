#pragma once

#include "lab/storage/event_waker.h"

#include <optional>

class Lab;

/// Wakes the window when a watched file changes, or a MIDI or OSC message arrives.
class LabWakers {
public:
    /// Follows the OSC port of the lab, which must outlive it.
    explicit LabWakers(Lab& lab);
    ~LabWakers();
    LabWakers(const LabWakers&) = delete;
    LabWakers& operator=(const LabWakers&) = delete;

private:
    Lab& m_lab;
    EventWaker m_files;
    EventWaker m_midi;
    std::optional<EventWaker> m_osc;  // while other programs can set parameters
};
