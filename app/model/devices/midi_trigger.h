#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>

/// A key, pad, button or program of a MIDI device that can run a command.
struct MidiTrigger {
    enum class Kind { note, program, control };

    Kind kind = Kind::note;
    int channel = 1;  // 1 .. 16
    int number = 0;   // of the note, program or controller, 0 .. 127

    bool operator==(const MidiTrigger&) const = default;
};

/// "Note 36, channel 10", "Program 3, channel 1", "CC 64, channel 1".
std::string to_string(const MidiTrigger& trigger);

/// A trigger that was pressed or released.
struct MidiPress {
    MidiTrigger trigger;
    bool is_down = true;

    bool operator==(const MidiPress&) const = default;
};

/// Parses one complete message of MIDI 1.0; nullopt if it is another type or truncated. A note of
/// velocity 0 is a release. A controller is down from 64, like a pedal. A program is never
/// released.
std::optional<MidiPress> parse_midi_press(std::span<const std::uint8_t> bytes);

/// Reduces the values of controllers to presses and releases: a fader at 100 and then at 101 is
/// one press.
class MidiPressDetector {
public:
    /// The press or release of a message; nullopt: none.
    std::optional<MidiPress> press(std::span<const std::uint8_t> bytes);

private:
    std::set<std::pair<int, int>> m_down;  // channel and controller
};

/// Runs a command on a press. A command is the end of an OSC address: "action/wipe".
struct MidiCommand {
    std::string command;
    MidiTrigger trigger;

    bool operator==(const MidiCommand&) const = default;
};
