#pragma once

#include "model/devices/midi.h"
#include "model/devices/midi_trigger.h"
#include "model/devices/network_reach.h"

#include <string_view>
#include <vector>

/// Settings for control by other programs and devices. User settings, not part of presets.
struct RemoteSettings {
    bool listens_to_osc = false;
    int osc_port = 9000;
    NetworkReach osc_reach = NetworkReach::this_machine;
    int osc_reply_port = 0;  // 0: the port of the sender
    bool listens_to_midi = false;
    bool has_soft_takeover = true;  // soft takeover: a knob must first pass the current value
    std::vector<MidiBinding> midi = {};
    std::vector<MidiCommand> midi_commands = {};

    bool operator==(const RemoteSettings&) const = default;
    /// A goal has one controller: replaces the previous binding.
    void bind(const MidiBinding& binding);
    void unbind(const MidiTarget& goal);
    /// A command has one trigger: replaces the previous one.
    void bind_command(const MidiCommand& command);
    void unbind_command(std::string_view command);
};
