#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

/// A controller of a MIDI device that was turned: Control Change of MIDI 1.0.
struct MidiTurn {
    int channel = 1;     // 1 .. 16
    int controller = 0;  // 0 .. 127
    int value = 0;       // 0 .. 127

    bool operator==(const MidiTurn&) const = default;
};

/// One whole message as a device sends it; none where it is another one, or cut off.
std::optional<MidiTurn> parse_midi(std::span<const std::uint8_t> bytes);

/// A parameter, or one number of a vector, as a controller turns it.
struct MidiGoal {
    std::string parameter;
    std::size_t component = 0;

    bool operator==(const MidiGoal&) const = default;
};

/// A controller, and what it turns in every look that has it.
struct MidiBinding {
    MidiGoal goal;
    int channel = 1;
    int controller = 0;
    bool is_fine = false;  // 14 bits: the lower seven come as controller + 32

    bool operator==(const MidiBinding&) const = default;
};

/// "CC 21, channel 1"; "CC 1 and 33, channel 1" of a fine one.
std::string words_of(const MidiBinding& binding);

/// Whether that is the lower half of a pair whose upper half is the binding's controller.
bool is_lower_half(const MidiTurn& turn, const MidiBinding& binding);

/// Puts the two halves of fine controllers together.
class MidiPairs {
public:
    /// How far along its way the bound controller is now, 0 .. 1; none where the message does not
    /// turn it, or is the upper half, which the lower one follows.
    std::optional<double> share(const MidiBinding& binding, const MidiTurn& turn) const;
    /// To be called with every message, after share().
    void note(const MidiTurn& turn);

private:
    std::map<std::pair<int, int>, int> m_upper;  // by channel and controller
};

/// Lets a knob turn what it is bound to without a jump: from where it comes by its value on.
class PickUp {
public:
    /// Whether a knob that has gone to `share` turns what is at `present`, both 0 .. 1.
    bool takes(double share, double present);
    /// Where what it turns is after that.
    void gave(double present) { m_given = present; }

private:
    std::optional<double> m_last;   // of the knob
    std::optional<double> m_given;  // while it is in the hand
};
