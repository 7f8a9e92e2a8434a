#include "ui/widgets/remote_menu.h"

#include "lab/remote/osc_parameters.h"
#include "lab/remote/remote_control.h"
#include "ui/widgets/scoped.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

namespace {
void unmap(const std::string& command, Edits& edits) {
    edits.change([command](RemoteControl& remote) {
        RemoteSettings settings = remote.settings();
        settings.unbind_command(command);
        remote.set_settings(settings);
    });
}

RemoteChoice draw_items(const RemoteItem& item, const Scene& scene, Edits& edits) {
    RemoteChoice choice = RemoteChoice::none;
    if (ImGui::MenuItem("MIDI learn")) {
        edits.change(
            [item](RemoteControl& remote) { remote.learn_midi_command(item.command, item.name); });
        choice = RemoteChoice::learn;
    }
    edits.mark("command_midi_learn");
    for (const MidiCommand& bound : scene.lab.remote.settings().midi_commands)
        if (bound.command == item.command) {
            if (ImGui::MenuItem(fmt::format("Unmap {}", to_string(bound.trigger)).c_str())) {
                unmap(item.command, edits);
                choice = RemoteChoice::other;
            }
            edits.mark("command_midi_unmap");
        }
    if (ImGui::MenuItem("Copy OSC address")) {
        edits.copy(fmt::format("{}command/{}", osc_prefix, item.command));
        choice = RemoteChoice::other;
    }
    edits.mark("command_copy_address");
    return choice;
}
}  // namespace

RemoteChoice draw_remote_menu(const RemoteItem& item, const Scene& scene, Edits& edits) {
    const ScopedId id(item.command);
    constexpr const char* popup = "##remote_menu";
    // Also for a disabled item: it can be mapped before it is available.
    const bool is_asked = ImGui::IsMouseReleased(ImGuiMouseButton_Right) &&
                          ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
    if (is_asked)
        ImGui::OpenPopup(popup);
    if (!ImGui::BeginPopup(popup))
        return RemoteChoice::none;
    const RemoteChoice choice = draw_items(item, scene, edits);
    ImGui::EndPopup();
    return choice;
}
