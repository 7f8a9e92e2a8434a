#include "ui/parameters/midi_items.h"

#include "lab/document/naming.h"
#include "lab/remote/osc_parameters.h"
#include "lab/remote/remote_control.h"
#include "model/tuning/slider_share.h"
#include "ui/frame/action_name.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace {
void unbind(const MidiTarget& goal, Edits& edits) {
    edits.change([goal](RemoteControl& remote) {
        RemoteSettings settings = remote.settings();
        settings.unbind(goal);
        remote.set_settings(settings);
    });
}

void draw_learn_item(const char* label, const MidiTarget& goal, Edits& edits) {
    if (ImGui::MenuItem(label))
        edits.change([goal](RemoteControl& remote) { remote.learn_midi(goal); });
    edits.mark(fmt::format("midi_learn:{}", goal.component));
}

const Parameter* meant_here(const MidiTarget& goal, const Document* document) {
    if (!document)
        return nullptr;
    const auto meant = resolve_parameter(goal.parameter, document->look());
    return meant ? *meant : nullptr;
}

// "Decay", "Centre · y".
std::string label_of(const Parameter& parameter, const MidiTarget& goal) {
    return parameter.type.size() > 1
               ? fmt::format("{} · {}", parameter.label, component_label(parameter, goal.component))
               : parameter.label;
}

void draw_binding(const MidiBinding& binding, const Scene& scene, Edits& edits) {
    const ScopedId id(fmt::format("{}:{}", binding.goal.parameter, binding.goal.component));
    ImGui::AlignTextToFramePadding();
    const float width = ImGui::GetFontSize() * 13.0f;
    if (const Parameter* parameter = meant_here(binding.goal, scene.lab.document))
        fitted_text(label_of(*parameter, binding.goal), width, theme::text);
    else
        fitted_text(fmt::format("{} (not in this look)", binding.goal.parameter), width,
                    theme::dim);
    ImGui::SameLine(width + ImGui::GetFontSize());
    dim_text(to_string(binding));
    same_line_right(ImGui::GetFrameHeight());
    if (icon_button("##unbind", Icon::close, "Remove this MIDI mapping", theme::dim))
        unbind(binding.goal, edits);
    edits.mark("midi_unbind:" + binding.goal.parameter);
}

void draw_command(const MidiCommand& bound, const Scene& scene, Edits& edits) {
    const ScopedId id(bound.command);
    ImGui::AlignTextToFramePadding();
    const float width = ImGui::GetFontSize() * 13.0f;
    fitted_text(command_label(bound.command, scene.actions), width, theme::text);
    ImGui::SameLine(width + ImGui::GetFontSize());
    dim_text(to_string(bound.trigger));
    same_line_right(ImGui::GetFrameHeight());
    if (icon_button("##unmap", Icon::close, "Remove this MIDI mapping", theme::dim))
        edits.change([command = bound.command](RemoteControl& remote) {
            RemoteSettings settings = remote.settings();
            settings.unbind_command(command);
            remote.set_settings(settings);
        });
    edits.mark("midi_unbind:" + bound.command);
}

std::string devices_text(const MidiControl& midi) {
    if (!midi.is_listening())
        return "MIDI is off.";
    const std::vector<std::string> devices = midi.devices();
    return devices.empty() ? "No MIDI device connected."
                           : fmt::format("Listening to {}", fmt::join(devices, ", "));
}

void draw_devices(const MidiControl& midi, Edits& edits) {
    ImGui::AlignTextToFramePadding();
    dim_text(devices_text(midi));
    same_line_right(ImGui::CalcTextSize("Rescan").x + 2.0f * ImGui::GetStyle().FramePadding.x);
    if (ImGui::Button("Rescan"))
        edits.change([](RemoteControl& remote) { remote.find_midi_devices(); });
    edits.mark("midi_look");
    if (!midi.last().empty())
        dim_text(fmt::format("Last message: {}", midi.last()));
}
}  // namespace

void draw_midi_items(const ParameterEntry& entry, Edits& edits) {
    const Parameter& parameter = entry.parameter;
    if (ImGui::MenuItem("Copy OSC address"))
        edits.copy(fmt::format("{}{}", osc_prefix, parameter.name));
    edits.mark("copy_osc_address");
    if (!has_slider_numbers(parameter))
        return;
    const auto count = static_cast<std::size_t>(parameter.type.size());
    if (count == 1) {
        draw_learn_item("MIDI learn", {parameter.name}, edits);
    } else if (ImGui::BeginMenu("MIDI learn")) {
        for (std::size_t i = 0; i < count; ++i)
            draw_learn_item(component_label(parameter, i).c_str(), {parameter.name, i}, edits);
        ImGui::EndMenu();
    }
    edits.mark("midi_learn");
    for (const MidiBinding& binding : entry.midi) {
        const std::string label =
            count > 1
                ? fmt::format("Unmap {} ({})", component_label(parameter, binding.goal.component),
                              to_string(binding))
                : fmt::format("Unmap {}", to_string(binding));
        if (ImGui::MenuItem(label.c_str()))
            unbind(binding.goal, edits);
        edits.mark("midi_let_go");
    }
}

void draw_midi_settings(const Scene& scene, Edits& edits) {
    const MidiControl& midi = scene.lab.remote.midi();
    RemoteSettings settings = scene.lab.remote.settings();
    ImGui::TextWrapped(
        "Control parameters by MIDI knobs and faders, and actions by pads, keys and program "
        "changes. Right-click a parameter, a menu item or a palette entry and "
        "choose MIDI learn.");
    ImGui::Spacing();
    settings.listens_to_midi = midi.is_listening();
    bool is_changed = ImGui::Checkbox("Listen to MIDI", &settings.listens_to_midi);
    edits.mark("midi_listen");
    ImGui::SameLine(0.0f, ImGui::GetFontSize() * 1.5f);
    is_changed |= ImGui::Checkbox("Soft takeover", &settings.has_soft_takeover);
    tooltip("A knob takes effect once it passes the current value, so that nothing jumps.");
    edits.mark("midi_picks_up");
    if (is_changed)
        edits.change([settings](RemoteControl& remote) { remote.set_settings(settings); });
    draw_devices(midi, edits);
    constexpr std::size_t max_rows = 8;
    const std::size_t rows =
        std::min(settings.midi.size() + settings.midi_commands.size(), max_rows);
    if (rows == 0)
        return;
    ImGui::BeginChild("##bindings",
                      {0.0f, static_cast<float>(rows) * ImGui::GetFrameHeightWithSpacing()});
    for (const MidiBinding& binding : settings.midi)
        draw_binding(binding, scene, edits);
    for (const MidiCommand& command : settings.midi_commands)
        draw_command(command, scene, edits);
    ImGui::EndChild();
}
