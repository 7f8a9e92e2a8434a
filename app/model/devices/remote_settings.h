#pragma once

#include "model/devices/midi.h"

#include <vector>

/// Settings for control by other programs and devices. User settings, not part of presets.
struct RemoteSettings {
    bool listens_to_osc = false;
    int osc_port = 9000;
    bool listens_to_midi = false;
    bool has_soft_takeover = true;  // soft takeover: a knob must first pass the current value
    std::vector<MidiBinding> midi = {};

    bool operator==(const RemoteSettings&) const = default;
    /// A goal has one controller: replaces the previous binding.
    void bind(const MidiBinding& binding);
    void unbind(const MidiTarget& goal);
};
