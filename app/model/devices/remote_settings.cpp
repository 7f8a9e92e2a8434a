#include "model/devices/remote_settings.h"

void RemoteSettings::bind(const MidiBinding& binding) {
    unbind(binding.goal);
    midi.push_back(binding);
}

void RemoteSettings::unbind(const MidiTarget& goal) {
    std::erase_if(midi, [&](const MidiBinding& bound) { return bound.goal == goal; });
}

void RemoteSettings::bind_command(const MidiCommand& command) {
    unbind_command(command.command);
    midi_commands.push_back(command);
}

void RemoteSettings::unbind_command(std::string_view command) {
    std::erase_if(midi_commands,
                  [&](const MidiCommand& bound) { return bound.command == command; });
}
