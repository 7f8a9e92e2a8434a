#pragma once

#include "base/diagnostic.h"
#include "io/control/midi_clock_input.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The MIDI input devices: listens to all connected devices.
class MidiInputs {
public:
    virtual ~MidiInputs() = default;

    /// Listens to all devices that are connected now. Fails, with nothing open, if no device is
    /// connected or the system has no MIDI.
    virtual Result<void> open() = 0;
    virtual void close() = 0;
    /// The names of the open devices.
    virtual std::vector<std::string> names() const = 0;
    /// The next complete message; nullopt if none is queued. Never waits.
    virtual std::optional<std::vector<std::uint8_t>> take() = 0;
    /// The clock that the devices send; null: not supported.
    virtual const MidiClockInput* clock() const { return nullptr; }
    /// Becomes readable when a message has been received. The same for the object's lifetime; -1:
    /// never.
    virtual int descriptor() const = 0;
};

/// The MIDI inputs of this machine.
std::unique_ptr<MidiInputs> machine_midi_inputs();
