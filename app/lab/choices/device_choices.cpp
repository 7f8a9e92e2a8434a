#include "lab/choices/device_choices.h"

#include "lab/lab.h"

#include <fmt/format.h>

#include <cmath>

namespace {
MenuCommand set_sound(const SoundSettings& settings) {
    return [settings](Lab& lab) { lab.audio().set_settings(settings); };
}

Choice sound_choice(std::string name, const SoundSettings& next, bool is_present) {
    return {.name = std::move(name), .commands = {set_sound(next)}, .is_present = is_present};
}

Choice sound_number(const char* name, const char* unit, double present, Limit limit,
                    const std::function<MenuCommand(double)>& command) {
    return {.name = name,
            .number = AskedNumber{
                .present = present,
                .unit = unit,
                .limit = limit,
                .answer = [command](double typed) -> MenuCommands { return {command(typed)}; }}};
}

void add_devices(const SoundFacts& facts, std::string SoundSettings::*device, const char* words,
                 std::vector<Choice>& choices) {
    const bool is_out = device == &SoundSettings::output;
    const auto offer = [&](const std::string& name, const std::string& label) {
        SoundSettings next = facts.settings;
        next.*device = name;
        choices.push_back(sound_choice(fmt::format("{}: {}", words, label), next,
                                       facts.settings.*device == name));
    };
    offer("", "System default");
    for (const SoundDevice& one : facts.devices)
        if (is_out ? one.has_output : one.has_input)
            offer(one.name, one.name);
}

void add_sizes(const SoundSettings& settings, std::vector<Choice>& choices) {
    for (const int rate : sound_rates) {
        SoundSettings next = settings;
        next.rate = rate;
        choices.push_back(
            sound_choice(rate == 0 ? "Rate: Device default" : fmt::format("Rate: {} Hz", rate),
                         next, settings.rate == rate));
    }
    for (const int buffer : sound_buffers) {
        SoundSettings next = settings;
        next.buffer = buffer;
        choices.push_back(sound_choice(fmt::format("Buffer: {} samples", buffer), next,
                                       settings.buffer == buffer));
    }
}

void add_sound_numbers(const SoundFacts& facts, std::vector<Choice>& choices) {
    const SoundSettings& settings = facts.settings;
    choices.push_back(sound_number("Picture delay…", "ms", settings.picture_delay_ms,
                                   {-200.0, 500.0}, [settings](double typed) {
                                       SoundSettings next = settings;
                                       next.picture_delay_ms = typed;
                                       return set_sound(next);
                                   }));
    choices.push_back(
        sound_number("Beam level…", "", settings.beam_level, {0.0, 1.0}, [settings](double typed) {
            SoundSettings next = settings;
            next.beam_level = typed;
            return set_sound(next);
        }));
    if (facts.sound_seconds <= 0.0)
        return;
    choices.push_back(sound_number("Volume…", "×", facts.level, {0.0, 2.0}, [](double typed) {
        return MenuCommand([typed](Lab& lab) { lab.player().set_level(typed); });
    }));
    choices.push_back(sound_number(
        "Go to…", "s", facts.place, {0.0, facts.sound_seconds},
        [](double typed) { return MenuCommand([typed](Lab& lab) { lab.player().seek(typed); }); }));
}

MenuCommand change_remote(const std::function<void(RemoteSettings&)>& change) {
    return [change](Lab& lab) {
        RemoteSettings settings = lab.remote().settings();
        settings.listens_to_osc = lab.remote().osc().is_listening();
        settings.listens_to_midi = lab.remote().midi().is_listening();
        change(settings);
        lab.remote().set_settings(settings);
    };
}
}  // namespace

ChoiceList sound_choices(const SoundFacts& facts) {
    ChoiceList list{"Sound"};
    SoundSettings beam = facts.settings;
    beam.plays_beam = !beam.plays_beam;
    list.choices.push_back(
        sound_choice("Send beam to audio output", beam, facts.settings.plays_beam));
    list.choices.push_back(
        {.name = "Rescan devices", .commands = {[](Lab& lab) { lab.audio().find_devices(); }}});
    add_devices(facts, &SoundSettings::output, "Output", list.choices);
    add_devices(facts, &SoundSettings::input, "Input", list.choices);
    add_sizes(facts.settings, list.choices);
    add_sound_numbers(facts, list.choices);
    return list;
}

ChoiceList remote_choices(const RemoteSettings& settings, bool hears_osc, bool hears_midi) {
    ChoiceList list{"Remote"};
    const auto offer = [&](std::string name, bool is_present,
                           const std::function<void(RemoteSettings&)>& change) {
        list.choices.push_back({.name = std::move(name),
                                .commands = {change_remote(change)},
                                .is_present = is_present});
    };
    offer("Listen to OSC", hears_osc,
          [next = !hears_osc](RemoteSettings& changed) { changed.listens_to_osc = next; });
    offer("Listen to MIDI", hears_midi,
          [next = !hears_midi](RemoteSettings& changed) { changed.listens_to_midi = next; });
    offer("Soft takeover", settings.picks_up,
          [](RemoteSettings& changed) { changed.picks_up = !changed.picks_up; });
    list.choices.push_back({.name = "Rescan MIDI devices",
                            .commands = {[](Lab& lab) { lab.remote().find_midi_devices(); }}});
    list.choices.push_back(
        {.name = "OSC port…",
         .number = AskedNumber{.present = static_cast<double>(settings.osc_port),
                               .limit = {1.0, 65535.0},
                               .is_whole = true,
                               .answer = [](double typed) -> MenuCommands {
                                   return {change_remote([typed](RemoteSettings& changed) {
                                       changed.osc_port = static_cast<int>(std::lround(typed));
                                   })};
                               }}});
    for (const MidiBinding& binding : settings.midi)
        offer(fmt::format("Unmap {} ({})", binding.goal.parameter, words_of(binding)), false,
              [goal = binding.goal](RemoteSettings& changed) { changed.unbind(goal); });
    return list;
}
