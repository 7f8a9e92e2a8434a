#include "lab/remote/midi_triggers.h"

#include <utility>

std::optional<MidiCommand> MidiTriggers::take(std::span<const std::uint8_t> message,
                                              const RemoteSettings& settings,
                                              std::vector<PressedCommand>& pressed) {
    const auto press = m_detector.press(message);
    if (!press)
        return std::nullopt;
    if (m_learning) {
        if (!press->is_down)
            return std::nullopt;
        return MidiCommand{*std::exchange(m_learning, {}), press->trigger};
    }
    for (const MidiCommand& bound : settings.midi_commands)
        if (bound.trigger == press->trigger)
            pressed.push_back({bound.command, press->is_down});
    return std::nullopt;
}
