#include "ui/dialogs/remote_dialog.h"

#include "lab/remote/remote_control.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/parameters/midi_items.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace {
constexpr double max_port = 65535.0;

// Settings with the actual state of OSC: the port may have been unavailable.
RemoteSettings current_settings(const Scene& scene) {
    RemoteSettings settings = scene.lab.remote.settings();
    settings.listens_to_osc = scene.lab.remote.osc().is_listening();
    return settings;
}

void change_settings(const RemoteSettings& settings, Edits& edits) {
    edits.change([settings](RemoteControl& remote) { remote.set_settings(settings); });
}

void draw_port(const char* label, const char* mark, double lowest, int RemoteSettings::*port,
               const Scene& scene, Edits& edits) {
    RemoteSettings settings = current_settings(scene);
    ImGui::AlignTextToFramePadding();
    dim_text(label);
    ImGui::SameLine();
    const ScopedId id(mark);
    const ScopedFont font(scene.fonts.numbers);
    double number = settings.*port;
    const NumberInfo info{.limit = Limit{lowest, max_port}, .is_whole = true};
    if (draw_number("##port", number, ImGui::GetFontSize() * 4.4f, info).is_changed) {
        settings.*port = static_cast<int>(std::lround(number));
        change_settings(settings, edits);
    }
    edits.mark(mark);
}

void draw_reach(const Scene& scene, Edits& edits) {
    constexpr std::array labels{"This machine", "Local network"};
    RemoteSettings settings = current_settings(scene);
    ImGui::AlignTextToFramePadding();
    dim_text("From");
    ImGui::SameLine();
    const int current = settings.osc_reach == NetworkReach::local_network ? 1 : 0;
    const int chosen =
        choice("osc_from", labels.data(), static_cast<int>(labels.size()), current, edits);
    if (chosen == current)
        return;
    settings.osc_reach = chosen == 1 ? NetworkReach::local_network : NetworkReach::this_machine;
    change_settings(settings, edits);
}

// The addresses to type into the sender.
void draw_addresses(const OscControl& osc, const Fonts& fonts) {
    const auto draw = [&](const std::string& host, const std::string& where) {
        {
            const ScopedFont font(fonts.numbers);
            ImGui::TextUnformatted(fmt::format("{}  port {}", host, osc.port()).c_str());
        }
        ImGui::SameLine(0.0f, ImGui::GetFontSize());
        dim_text(where);
    };
    if (osc.reach() == NetworkReach::this_machine)
        return draw("127.0.0.1", "programs on this machine");
    for (const LocalNetwork& network : osc.networks())
        draw(host_text(network.host),
             fmt::format("devices in the network of {}", network.interface));
    if (osc.networks().empty())
        wrapped_dim_text("No network found. Only programs on this machine can send.");
    const ScopedColor color(ImGuiCol_Text, theme::warning);
    ImGui::TextWrapped(
        "OSC has no password: every device in these networks can control Afterglow.");
}

void draw_counts(const Scene& scene, Edits& edits) {
    const RemoteLog& log = scene.lab.remote.log();
    ImGui::AlignTextToFramePadding();
    dim_text(fmt::format("{} accepted, {} rejected", log.accepted(), log.rejected()));
    constexpr const char* label = "Show rejected";
    same_line_right(ImGui::CalcTextSize(label).x + 2.0f * ImGui::GetStyle().FramePadding.x);
    if (ImGui::Button(label)) {
        edits.arrange([](WindowState& window) { window.layout.reveal(panel_id::remote); });
        close_dialog(edits);
    }
    edits.mark("remote_show_rejected");
}

void draw_osc_settings(const Scene& scene, Edits& edits) {
    RemoteSettings settings = current_settings(scene);
    ImGui::TextWrapped(
        "Control parameters, presets and all actions from other programs and tablets by OSC over "
        "UDP. The page \"Remote control\" of the manual lists the addresses.");
    ImGui::Spacing();
    if (ImGui::Checkbox("Listen to OSC", &settings.listens_to_osc))
        change_settings(settings, edits);
    edits.mark("osc_listen");
    ImGui::SameLine(0.0f, ImGui::GetFontSize() * 1.5f);
    draw_reach(scene, edits);
    draw_port("Port", "osc_port", 1.0, &RemoteSettings::osc_port, scene, edits);
    ImGui::SameLine(0.0f, ImGui::GetFontSize() * 1.5f);
    draw_port("Reply to port", "osc_reply_port", 0.0, &RemoteSettings::osc_reply_port, scene,
              edits);
    tooltip("Replies to queries go to this port of the sender. 0: the port that it sends from.");
    const OscControl& osc = scene.lab.remote.osc();
    if (osc.is_listening())
        draw_addresses(osc, scene.fonts);
    else
        dim_text("OSC is off.");
}
}  // namespace

void draw_remote_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("Remote control", 34.0f, scene, edits);
    if (!frame.is_open())
        return;
    draw_osc_settings(scene, edits);
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    draw_midi_settings(scene, edits);
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    draw_counts(scene, edits);
    draw_close_button("Close", edits);
}
