#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

/// A Control Change message of MIDI 1.0.
struct MidiControlChange {
    int channel = 1;     // 1 .. 16
    int controller = 0;  // 0 .. 127
    int value = 0;       // 0 .. 127

    bool operator==(const MidiControlChange&) const = default;
};

/// Parses one complete message; nullopt if it is another type or truncated.
std::optional<MidiControlChange> parse_midi(std::span<const std::uint8_t> bytes);

/// The target of a controller: a parameter, or one component of a vector.
struct MidiTarget {
    std::string parameter;
    std::size_t component = 0;

    bool operator==(const MidiTarget&) const = default;
};

/// Binds a controller to a parameter, in every look that has it.
struct MidiBinding {
    MidiTarget goal;
    int channel = 1;
    int controller = 0;
    bool is_fine = false;  // 14 bits: controller + 32 has the lower seven

    bool operator==(const MidiBinding&) const = default;
};

/// "CC 21, channel 1"; for a fine controller "CC 1 and 33, channel 1".
std::string to_string(const MidiBinding& binding);

/// Whether the message is the lower half of the binding's 14-bit controller.
bool is_lower_half(const MidiControlChange& change, const MidiBinding& binding);

/// Combines the two halves of 14-bit controllers.
class Midi14BitDecoder {
public:
    /// The position of the bound controller, 0 .. 1. nullopt if the message does not change it, or
    /// is the upper half: the lower half follows.
    std::optional<double> share(const MidiBinding& binding, const MidiControlChange& change) const;
    /// Call with every message, after share().
    void note(const MidiControlChange& change);

private:
    std::map<std::pair<int, int>, int> m_upper;  // by channel and controller
};

/// Soft takeover: a knob takes effect once it passes the current value, so that nothing jumps.
class SoftTakeover {
public:
    /// Whether a knob at `share` changes a parameter at `current`, both 0 .. 1.
    bool accepts(double share, double current);
    /// Sets the parameter's position after that change.
    void record(double current) { m_given = current; }

private:
    std::optional<double> m_last;   // position of the knob
    std::optional<double> m_given;  // position of the parameter, while the knob controls it
};
