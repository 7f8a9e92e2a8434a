#pragma once

#include "base/diagnostic.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The MIDI devices that are listened to, all that there are.
class MidiInputs {
public:
    virtual ~MidiInputs() = default;

    /// Listens to the devices that there are now. Fails where there is none, or no MIDI at all;
    /// then nothing is listened to.
    virtual Result<void> open() = 0;
    virtual void close() = 0;
    /// Of the devices that are listened to.
    virtual std::vector<std::string> names() const = 0;
    /// The next message that has come, whole; none when there is none. Never waits.
    virtual std::optional<std::vector<std::uint8_t>> take() = 0;
    /// Becomes readable when a message has come, the same as long as this lives; -1: never.
    virtual int descriptor() const = 0;
};

/// Those of this machine.
std::unique_ptr<MidiInputs> machine_midi_inputs();
