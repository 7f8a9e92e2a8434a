#pragma once

#include "io/sound/sound_devices.h"
#include "lab/messages/menu_entry.h"
#include "model/devices/remote_settings.h"
#include "model/devices/sound_settings.h"

/// The state of audio. `sound_seconds`: duration of the playing file; 0: no file.
struct SoundControls {
    SoundSettings settings;
    std::vector<SoundDevice> devices;
    double level = 1.0;
    double position = 0.0;  // s
    double sound_seconds = 0.0;
};
MenuSection sound_section(const SoundControls& info);

/// Settings of remote control: OSC and MIDI.
MenuSection remote_section(const RemoteSettings& settings, bool hears_osc, bool hears_midi);

inline constexpr std::array sound_rates{0, 44100, 48000, 96000, 192000};
inline constexpr std::array sound_buffers{128, 256, 512, 1024, 2048, 4096};
