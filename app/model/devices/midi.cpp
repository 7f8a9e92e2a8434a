#include "model/devices/midi.h"

#include <fmt/format.h>

#include <cmath>

namespace {
constexpr int lower_half =
    32;  // offset of the lower 7 bits of controllers 0 .. 31 (MIDI 1.0, table 3)
}

std::optional<MidiControlChange> parse_midi(std::span<const std::uint8_t> bytes) {
    constexpr unsigned control_change = 0xb0;
    constexpr unsigned maximum = 127;
    if (bytes.size() != 3 || (bytes[0] & 0xf0u) != control_change || bytes[1] > maximum ||
        bytes[2] > maximum)
        return std::nullopt;
    return MidiControlChange{static_cast<int>(bytes[0] & 0x0fu) + 1, bytes[1], bytes[2]};
}

std::string to_string(const MidiBinding& binding) {
    if (binding.is_fine)
        return fmt::format("CC {} and {}, channel {}", binding.controller,
                           binding.controller + lower_half, binding.channel);
    return fmt::format("CC {}, channel {}", binding.controller, binding.channel);
}

bool is_lower_half(const MidiControlChange& change, const MidiBinding& binding) {
    return binding.controller < lower_half && change.channel == binding.channel &&
           change.controller == binding.controller + lower_half;
}

std::optional<double> Midi14BitDecoder::share(const MidiBinding& binding,
                                              const MidiControlChange& change) const {
    if (!binding.is_fine) {
        const bool is_it =
            change.channel == binding.channel && change.controller == binding.controller;
        return is_it ? std::optional(change.value / 127.0) : std::nullopt;
    }
    const auto upper = m_upper.find({binding.channel, binding.controller});
    if (!is_lower_half(change, binding) || upper == m_upper.end())
        return std::nullopt;
    return (upper->second * 128 + change.value) / 16383.0;
}

void Midi14BitDecoder::note(const MidiControlChange& change) {
    if (change.controller < lower_half)
        m_upper[{change.channel, change.controller}] = change.value;
}

bool SoftTakeover::accepts(double share, double current) {
    constexpr double close = 1.0 / 127.0 + 1e-9;  // a step of a plain controller
    constexpr double same = 1e-9;
    const bool is_picked_up = m_given && std::abs(*m_given - current) <= same;
    const bool comes_by = m_last && (*m_last - current) * (share - current) <= 0.0;
    const bool accepts = is_picked_up || comes_by || std::abs(share - current) <= close;
    m_last = share;
    if (!accepts)
        m_given.reset();
    return accepts;
}
