#include "model/devices/remote_settings.h"

void RemoteSettings::bind(const MidiBinding& binding) {
    unbind(binding.goal);
    midi.push_back(binding);
}

void RemoteSettings::unbind(const MidiTarget& goal) {
    std::erase_if(midi, [&](const MidiBinding& bound) { return bound.goal == goal; });
}
