#include "model/devices/midi_trigger.h"

#include <fmt/format.h>

namespace {
constexpr int maximum = 127;

// The message types of MIDI 1.0, table 1: the upper half of the first byte.
enum MessageType : unsigned { note_off = 0x80, note_on = 0x90, control = 0xb0, program = 0xc0 };

const char* kind_text(MidiTrigger::Kind kind) {
    switch (kind) {
        case MidiTrigger::Kind::note:
            return "Note";
        case MidiTrigger::Kind::program:
            return "Program";
        case MidiTrigger::Kind::control:
            return "CC";
    }
    return "";
}
}  // namespace

std::string to_string(const MidiTrigger& trigger) {
    return fmt::format("{} {}, channel {}", kind_text(trigger.kind), trigger.number,
                       trigger.channel);
}

std::optional<MidiPress> parse_midi_press(std::span<const std::uint8_t> bytes) {
    using Kind = MidiTrigger::Kind;
    if (bytes.size() < 2 || bytes[1] > maximum)
        return std::nullopt;
    const unsigned type = bytes[0] & 0xf0u;
    const int channel = static_cast<int>(bytes[0] & 0x0fu) + 1;
    if (type == program)
        return bytes.size() == 2
                   ? std::optional(MidiPress{{Kind::program, channel, bytes[1]}, true})
                   : std::nullopt;
    if (bytes.size() != 3 || bytes[2] > maximum)
        return std::nullopt;
    constexpr int half = 64;
    switch (type) {
        case note_off:
            return MidiPress{{Kind::note, channel, bytes[1]}, false};
        case note_on:
            return MidiPress{{Kind::note, channel, bytes[1]}, bytes[2] > 0};
        case control:
            return MidiPress{{Kind::control, channel, bytes[1]}, bytes[2] >= half};
        default:
            return std::nullopt;
    }
}

std::optional<MidiPress> MidiPressDetector::press(std::span<const std::uint8_t> bytes) {
    const auto press = parse_midi_press(bytes);
    if (!press || press->trigger.kind != MidiTrigger::Kind::control)
        return press;
    const std::pair id{press->trigger.channel, press->trigger.number};
    const bool was_down = m_down.contains(id);
    if (press->is_down)
        m_down.insert(id);
    else
        m_down.erase(id);
    return press->is_down != was_down ? press : std::nullopt;
}
