#pragma once

#include "model/devices/remote_settings.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

/// A command whose trigger was pressed or released.
struct PressedCommand {
    std::string command;
    bool is_down = true;

    bool operator==(const PressedCommand&) const = default;
};

/// Runs commands by notes, programs and buttons of MIDI devices, and learns their mapping.
class MidiTriggers {
public:
    /// Binds the next pressed trigger to the command; nullopt: stops learning.
    void learn(std::optional<std::string> command) { m_learning = std::move(command); }
    const std::optional<std::string>& learning() const { return m_learning; }

    /// Handles a message. Returns a learnt mapping; otherwise adds the commands that the message
    /// runs to `pressed`. While learning, no command runs.
    std::optional<MidiCommand> take(std::span<const std::uint8_t> message,
                                    const RemoteSettings& settings,
                                    std::vector<PressedCommand>& pressed);

private:
    std::optional<std::string> m_learning;
    MidiPressDetector m_detector;
};
