#include "lab/menus/device_menu.h"

#include "lab/playback/audio_control.h"
#include "lab/playback/player.h"
#include "lab/remote/remote_control.h"

#include <fmt/format.h>

#include <cmath>

namespace {
Edit set_sound(const SoundSettings& settings) {
    return [settings](AudioControl& audio) { audio.set_settings(settings); };
}

MenuEntry sound_entry(std::string name, const SoundSettings& next, bool is_present) {
    return {.name = std::move(name), .commands = {set_sound(next)}, .is_present = is_present};
}

MenuEntry sound_number(const char* name, const char* unit, double current, Limit limit,
                       const std::function<Edit(double)>& command) {
    return {.name = name,
            .number = NumberPrompt{.current = current,
                                   .unit = unit,
                                   .limit = limit,
                                   .answer = [command](double typed) -> std::vector<Edit> {
                                       return {command(typed)};
                                   }}};
}

void add_devices(const SoundControls& info, std::string SoundSettings::*device, const char* text,
                 std::vector<MenuEntry>& entries) {
    const bool is_out = device == &SoundSettings::output;
    const auto offer = [&](const std::string& name, const std::string& label) {
        SoundSettings next = info.settings;
        next.*device = name;
        entries.push_back(
            sound_entry(fmt::format("{}: {}", text, label), next, info.settings.*device == name));
    };
    offer("", "System default");
    for (const SoundDevice& one : info.devices)
        if (is_out ? one.has_output : one.has_input)
            offer(one.name, one.name);
}

void add_sizes(const SoundSettings& settings, std::vector<MenuEntry>& entries) {
    for (const int rate : sound_rates) {
        SoundSettings next = settings;
        next.rate = rate;
        entries.push_back(
            sound_entry(rate == 0 ? "Rate: Device default" : fmt::format("Rate: {} Hz", rate), next,
                        settings.rate == rate));
    }
    for (const int buffer : sound_buffers) {
        SoundSettings next = settings;
        next.buffer = buffer;
        entries.push_back(sound_entry(fmt::format("Buffer: {} samples", buffer), next,
                                      settings.buffer == buffer));
    }
}

void add_sound_numbers(const SoundControls& info, std::vector<MenuEntry>& entries) {
    const SoundSettings& settings = info.settings;
    entries.push_back(sound_number("Picture delay…", "ms", settings.picture_delay_ms,
                                   {-200.0, 500.0}, [settings](double typed) {
                                       SoundSettings next = settings;
                                       next.picture_delay_ms = typed;
                                       return set_sound(next);
                                   }));
    entries.push_back(
        sound_number("Beam level…", "", settings.beam_level, {0.0, 1.0}, [settings](double typed) {
            SoundSettings next = settings;
            next.beam_level = typed;
            return set_sound(next);
        }));
    if (info.sound_seconds <= 0.0)
        return;
    entries.push_back(sound_number("Volume…", "×", info.level, {0.0, 2.0}, [](double typed) {
        return Edit([typed](Player& player) { player.set_level(typed); });
    }));
    entries.push_back(sound_number(
        "Go to…", "s", info.position, {0.0, info.sound_seconds},
        [](double typed) { return Edit([typed](Player& player) { player.seek(typed); }); }));
}

Edit change_remote(const std::function<void(RemoteSettings&)>& change) {
    return [change](RemoteControl& remote) {
        RemoteSettings settings = remote.settings();
        settings.listens_to_osc = remote.osc().is_listening();
        settings.listens_to_midi = remote.midi().is_listening();
        change(settings);
        remote.set_settings(settings);
    };
}

MenuEntry port_entry(const char* name, int current, double lowest, int RemoteSettings::*port,
                     std::string help) {
    const auto answer = [port](double typed) -> std::vector<Edit> {
        return {change_remote([port, typed](RemoteSettings& changed) {
            changed.*port = static_cast<int>(std::lround(typed));
        })};
    };
    return {.name = name,
            .number = NumberPrompt{.current = static_cast<double>(current),
                                   .limit = {lowest, 65535.0},
                                   .is_whole = true,
                                   .help = std::move(help),
                                   .answer = answer}};
}
}  // namespace

MenuSection sound_section(const SoundControls& info) {
    MenuSection section{"Sound"};
    SoundSettings beam = info.settings;
    beam.plays_beam = !beam.plays_beam;
    section.entries.push_back(
        sound_entry("Send beam to audio output", beam, info.settings.plays_beam));
    section.entries.push_back({.name = "Rescan devices",
                               .commands = {[](AudioControl& audio) { audio.find_devices(); }}});
    add_devices(info, &SoundSettings::output, "Output", section.entries);
    add_devices(info, &SoundSettings::input, "Input", section.entries);
    add_sizes(info.settings, section.entries);
    add_sound_numbers(info, section.entries);
    return section;
}

MenuSection remote_section(const RemoteSettings& settings, bool hears_osc, bool hears_midi) {
    MenuSection section{"Remote"};
    const auto offer = [&](std::string name, bool is_present,
                           const std::function<void(RemoteSettings&)>& change) {
        section.entries.push_back({.name = std::move(name),
                                   .commands = {change_remote(change)},
                                   .is_present = is_present});
    };
    offer("Listen to OSC", hears_osc,
          [next = !hears_osc](RemoteSettings& changed) { changed.listens_to_osc = next; });
    for (const auto& [name, reach] :
         {std::pair{"OSC from this machine", NetworkReach::this_machine},
          std::pair{"OSC from the local network", NetworkReach::local_network}})
        offer(name, settings.osc_reach == reach,
              [chosen = reach](RemoteSettings& changed) { changed.osc_reach = chosen; });
    offer("Listen to MIDI", hears_midi,
          [next = !hears_midi](RemoteSettings& changed) { changed.listens_to_midi = next; });
    offer("Soft takeover", settings.has_soft_takeover,
          [](RemoteSettings& changed) { changed.has_soft_takeover = !changed.has_soft_takeover; });
    section.entries.push_back(
        {.name = "Rescan MIDI devices",
         .commands = {[](RemoteControl& remote) { remote.find_midi_devices(); }}});
    section.entries.push_back(
        port_entry("OSC port…", settings.osc_port, 1.0, &RemoteSettings::osc_port, {}));
    section.entries.push_back(port_entry("OSC reply port…", settings.osc_reply_port, 0.0,
                                         &RemoteSettings::osc_reply_port,
                                         "0: the port that the sender uses"));
    for (const MidiBinding& binding : settings.midi)
        offer(fmt::format("Unmap {} ({})", binding.goal.parameter, to_string(binding)), false,
              [goal = binding.goal](RemoteSettings& changed) { changed.unbind(goal); });
    for (const MidiCommand& bound : settings.midi_commands)
        offer(fmt::format("Unmap {} ({})", bound.command, to_string(bound.trigger)), false,
              [command = bound.command](RemoteSettings& changed) {
                  changed.unbind_command(command);
              });
    return section;
}
