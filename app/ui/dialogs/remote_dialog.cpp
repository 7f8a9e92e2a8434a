#include "ui/dialogs/remote_dialog.h"

#include "lab/remote/remote_control.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/parameters/midi_items.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <cmath>

namespace {
void draw_port(const Scene& scene, Edits& edits) {
    RemoteSettings settings = scene.lab.remote.settings();
    ImGui::AlignTextToFramePadding();
    dim_text("Port");
    ImGui::SameLine();
    const ScopedFont font(scene.fonts.numbers);
    double port = settings.osc_port;
    const NumberInfo info{.limit = Limit{1.0, 65535.0}, .is_whole = true};
    if (draw_number("##port", port, ImGui::GetFontSize() * 4.4f, info).is_changed) {
        settings.osc_port = static_cast<int>(std::lround(port));
        edits.change([settings](RemoteControl& remote) { remote.set_settings(settings); });
    }
    edits.mark("osc_port");
}

void draw_what_came(const OscControl& osc) {
    if (!osc.is_listening()) {
        dim_text("OSC is off.");
        return;
    }
    dim_text(fmt::format("Listening on 127.0.0.1, port {}: {} accepted, {} rejected", osc.port(),
                         osc.applied(), osc.refused()));
    wrapped_dim_text(osc.problem().empty() ? std::string("Last rejected: none")
                                           : fmt::format("Last rejected: {}", osc.problem()));
}
}  // namespace

void draw_remote_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("Remote control", 32.0f, scene, edits);
    if (!frame.is_open())
        return;
    ImGui::TextWrapped(
        "Set parameters from other programs on this computer by OSC over UDP. Send "
        "/afterglow/NAME with one number, one per component for vectors, or text for list "
        "items.");
    ImGui::Spacing();
    RemoteSettings settings = scene.lab.remote.settings();
    settings.listens_to_osc = scene.lab.remote.osc().is_listening();
    if (ImGui::Checkbox("Listen to OSC", &settings.listens_to_osc))
        edits.change([settings](RemoteControl& remote) { remote.set_settings(settings); });
    edits.mark("osc_listen");
    draw_port(scene, edits);
    draw_what_came(scene.lab.remote.osc());
    ImGui::Spacing();
    ImGui::Separator();
    ImGui::Spacing();
    draw_midi_settings(scene, edits);
    draw_close_button("Close", edits);
}
