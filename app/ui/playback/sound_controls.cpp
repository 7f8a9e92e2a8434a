#include "ui/playback/sound_controls.h"

#include "lab/menus/device_menu.h"
#include "lab/playback/audio_control.h"
#include "lab/sequencer/sound_region.h"
#include "ui/playback/timeline.h"
#include "ui/widgets/form.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <cctype>
#include <cmath>

std::string clock_text(double seconds) {
    const double whole = std::floor(seconds / 60.0);
    return fmt::format("{:.0f}:{:05.2f}", whole, seconds - whole * 60.0);
}

namespace {
void draw_seek_bar(const Scene& scene, Edits& edits) {
    draw_timeline("seek", {form_width(), ImGui::GetFontSize() * 4.2f}, scene, edits);
    const PlayedPart part = *played_part(scene.lab.player.signal());
    const double position = part.position_at(scene.lab.player.transport().time());
    const ScopedFont font(scene.fonts.numbers);
    dim_text(fmt::format("{} / {}", clock_text(position),
                         clock_text(scene.lab.player.signal().sound().sound->seconds())));
}

void draw_volume(const AudioDevices& devices, const Scene& scene, Edits& edits) {
    const ScopedId id(std::string("volume"));
    const FormColumns columns = form_columns();
    form_label("Volume", columns, false);
    tooltip("Playback volume. It doesn't change the trace.");
    form_control(columns);
    double level = devices.level();
    if (form_slider(
            "##value", level,
            {.low = 0.0, .high = 2.0, .initial = 1.0, .unit = "×", .limit = Limit{0.0, 2.0}},
            columns, scene.fonts)
            .is_changed)
        edits.change([level](Player& player) { player.set_level(level); });
}

void apply(const SoundSettings& settings, Edits& edits) {
    edits.change([settings](AudioControl& audio) { audio.set_settings(settings); });
}

void begin_line(const std::string& label, const std::string& help, const FormColumns& columns) {
    form_label(label, columns, false);
    tooltip(help);
    form_control(columns);
}

enum class Way { out, in };

// Opening the list searches for devices. Until it is done, the previous list is displayed.
void draw_device(Way way, const Scene& scene, Edits& edits) {
    const bool is_out = way == Way::out;
    const ScopedId id(std::string(is_out ? "output" : "input"));
    const FormColumns columns = form_columns();
    begin_line(is_out ? "Output" : "Input",
               is_out ? "Audio device for playback."
                      : "Audio device for live input. A monitor records what other programs play.",
               columns);
    SoundSettings settings = scene.lab.player.devices().settings();
    std::string& chosen = is_out ? settings.output : settings.input;
    const bool is_open = begin_combo("##device", chosen.empty() ? "System default" : chosen,
                                     columns.control_and_number());
    edits.mark(is_out ? "sound:output" : "sound:input");
    if (!is_open)
        return;
    if (ImGui::IsWindowAppearing())
        edits.change([](AudioControl& audio) { audio.find_devices(); });
    const auto offer = [&](const std::string& name, const std::string& label) {
        const bool is_clicked = ImGui::Selectable(label.c_str(), name == chosen);
        focus_list_item(label, name == chosen);
        if (!is_clicked)
            return;
        chosen = name;
        apply(settings, edits);
    };
    offer("", "System default");
    for (const SoundDevice& device : scene.lab.audio.devices())
        if (is_out ? device.has_output : device.has_input)
            offer(device.name, device.name);
    ImGui::EndCombo();
}

void draw_number_choice(const char* label, const char* help, int SoundSettings::*setting,
                        const std::vector<int>& numbers, const Scene& scene, Edits& edits) {
    const ScopedId id{std::string(label)};
    const FormColumns columns = form_columns();
    begin_line(label, help, columns);
    SoundSettings settings = scene.lab.player.devices().settings();
    std::vector<std::string> labels;
    std::vector<const char*> texts;
    int chosen = -1;
    for (const int number : numbers) {
        if (number == settings.*setting)
            chosen = static_cast<int>(labels.size());
        labels.push_back(number == 0 ? "Device default" : std::to_string(number));
    }
    for (const std::string& one : labels)
        texts.push_back(one.c_str());
    if (form_list("##value", texts.data(), static_cast<int>(texts.size()), chosen,
                  columns.control_and_number())) {
        settings.*setting = numbers[static_cast<std::size_t>(chosen)];
        apply(settings, edits);
    }
    edits.mark("sound:" + std::string(label));
}

void draw_delay(const Scene& scene, Edits& edits) {
    const ScopedId id(std::string("delay"));
    const FormColumns columns = form_columns();
    begin_line("Picture delay",
               "Delays the picture to match loudspeakers with latency, such as Bluetooth.",
               columns);
    SoundSettings settings = scene.lab.player.devices().settings();
    const ValueEdit edited = form_slider("##value", settings.picture_delay_ms,
                                         {.low = -200.0, .high = 500.0, .step = 1.0, .unit = "ms"},
                                         columns, scene.fonts);
    edits.mark("sound:delay");
    if (edited.is_finished)
        apply(settings, edits);
    else if (edited.is_changed)
        edits.change([settings](Player& player) { (void)player.set_sound_settings(settings); });
}

void draw_beam_output(const Scene& scene, Edits& edits) {
    SoundSettings settings = scene.lab.player.devices().settings();
    if (ImGui::Checkbox("Send beam to audio output", &settings.plays_beam))
        apply(settings, edits);
    edits.mark("sound:beam");
    tooltip(
        "Draws on a real oscilloscope in XY mode: left is x, right is y. It can be loud, so don't "
        "use loudspeakers. Sound files are silent at the same time.");
    if (!settings.plays_beam)
        return;
    const ScopedId id(std::string("beam_level"));
    const FormColumns columns = form_columns();
    begin_line("Beam level", "Output level at full deflection. 1 is the output's maximum.",
               columns);
    const ValueEdit edited =
        form_slider("##value", settings.beam_level,
                    {.low = 0.0, .high = 1.0, .limit = Limit{0.0, 1.0}}, columns, scene.fonts);
    edits.mark("sound:beam_level");
    if (edited.is_finished)
        apply(settings, edits);
    else if (edited.is_changed)
        edits.change([settings](Player& player) { (void)player.set_sound_settings(settings); });
}
}  // namespace

void draw_sound_devices(bool is_live, const Scene& scene, Edits& edits) {
    {
        const ScopedFont strong(scene.fonts.strong);
        const bool is_open = section("Audio devices", false);
        edits.mark("signal_group:Sound devices");
        if (!is_open)
            return;
    }
    draw_beam_output(scene, edits);
    const Player& player = scene.lab.player;
    const bool has_sound = player.signal().sound().sound != nullptr;
    const bool is_heard = player.devices().settings().plays_beam || has_sound;
    if (is_live)
        draw_device(Way::in, scene, edits);
    if (is_heard)
        draw_device(Way::out, scene, edits);
    if (!is_live && !is_heard)
        return;
    draw_number_choice("Rate", "Sample rate in Hz.", &SoundSettings::rate,
                       {sound_rates.begin(), sound_rates.end()}, scene, edits);
    draw_number_choice(
        "Buffer", "Buffer size in samples. Smaller means lower latency, larger avoids dropouts.",
        &SoundSettings::buffer, {sound_buffers.begin(), sound_buffers.end()}, scene, edits);
    if (is_live || has_sound)
        draw_delay(scene, edits);
}

void draw_sound_controls(bool is_live, const Scene& scene, Edits& edits) {
    const Player& player = scene.lab.player;
    const PlayedSignal& signal = player.signal();
    const std::string input = signal.live_input().device_name();
    if (signal.sound().sound)
        draw_seek_bar(scene, edits);
    if (signal.sound().sound && player.devices().beam_device().empty())
        draw_volume(player.devices(), scene, edits);
    else if (is_live && !input.empty())
        fitted_text(fmt::format("Input: {}", input), ImGui::GetContentRegionAvail().x, theme::dim);
    draw_audio_error(scene);
}

void draw_audio_error(const Scene& scene) {
    const Player& player = scene.lab.player;
    const BeamFeed* feed = player.signal().feed();
    for (std::string text : {feed ? feed->state() : std::string(), player.error()}) {
        if (text.empty())
            continue;
        text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
        const ScopedColor color(ImGuiCol_Text, theme::label);
        ImGui::TextWrapped("%s", text.c_str());
    }
}
