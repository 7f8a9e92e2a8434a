#pragma once

#include "model/devices/midi_clock.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>

/// The MIDI clock that the input devices send. Device threads write, the window's thread reads.
class MidiClockInput {
public:
    /// Seconds of the clock that times the messages.
    static double now();

    /// Whether a message belongs to a clock: a real-time byte or a song position.
    static bool is_clock_message(std::span<const unsigned char> message);
    /// A message of the clock that `device` sent at this time. While the clock of one device is
    /// present, those of others are ignored.
    void receive(std::span<const unsigned char> message, std::size_t device, double seconds);
    /// The clock as received so far.
    MidiClock clock() const;

private:
    mutable std::mutex m_mutex;
    MidiClock m_clock;
    std::size_t m_device = 0;
};
