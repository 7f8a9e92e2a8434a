#pragma once

#include "model/devices/midi.h"

#include <vector>

/// What other programs and devices may turn; the user's settings, in no preset.
struct RemoteSettings {
    bool listens_to_osc = false;
    int osc_port = 9000;
    bool listens_to_midi = false;
    bool picks_up = true;  // a knob turns nothing before it has come by its value
    std::vector<MidiBinding> midi = {};

    bool operator==(const RemoteSettings&) const = default;
    /// A goal has one controller: the former one is let go.
    void bind(const MidiBinding& binding);
    void unbind(const MidiGoal& goal);
};
