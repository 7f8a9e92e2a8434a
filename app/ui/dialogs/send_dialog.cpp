#include "ui/dialogs/send_dialog.h"

#include "lab/frame/pass_control.h"
#include "lab/media/render_size.h"
#include "lab/send/look_sender.h"
#include "lab/send/running_program.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/dialog_rows.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

namespace {
void draw_address(SendForm& form, const RunningProgram& program, Edits& edits) {
    dialog_row(program.kind_of_address.c_str());
    std::string& typed = form.addresses[program.name];
    typed = dialog_text("send_address", typed, program.address, ImGui::GetContentRegionAvail().x,
                        edits);
    dialog_row("");
    wrapped_dim_text(program.help);
}

// Unticking it ends the sending at once.
void draw_follows(SendForm& form, Edits& edits) {
    dialog_row("");
    if (ImGui::Checkbox("Send after each edit", &form.follows) && !form.follows)
        edits.change([](LookSender& sending) { sending.stop_following(); });
    edits.mark("send_follows");
}

void draw_outcome(const LookSender& sender, std::size_t program, Edits& edits) {
    const auto& outcome = sender.work().outcome();
    const bool is_ours = sender.settings().program == program;
    dialog_row("");
    if (sender.work().is_running()) {
        dim_text("Sending…");
    } else if (!is_ours || !outcome) {
        dim_text("Not sent yet");
    } else if (*outcome) {
        dim_text(fmt::format("Sent to {}", running_programs()[program].name));
        edits.mark("send_done");
    } else {
        const ScopedColor color(ImGuiCol_Text, theme::warning);
        ImGui::TextWrapped("%s", outcome->error().front().message.c_str());
        edits.mark("send_failed");
    }
}

void send(const SendSettings& settings, Edits& edits) {
    edits.change([settings](LookSender& sender, const Document& document, const PassControl& passes,
                            const RenderSize& size) {
        sender.send(document, passes.switches(), size.extent(), settings);
    });
}
}  // namespace

void draw_send_dialog(const Scene& scene, Edits& edits) {
    if (!scene.lab.document)
        return close_dialog(edits);
    SendForm form = scene.window.sending;
    const RunningProgram& program = running_programs()[form.program];
    const DialogFrame frame(fmt::format("Send to {}", program.name).c_str(), 34.0f, scene, edits);
    if (!frame.is_open())
        return;
    const LookSender& sender = scene.lab.sender;
    draw_address(form, program, edits);
    draw_follows(form, edits);
    draw_outcome(sender, form.program, edits);
    const std::string& typed = form.addresses[program.name];
    const SendSettings settings{form.program, typed.empty() ? program.address : typed,
                                form.follows};
    edits.arrange([form](WindowState& window) { window.sending = form; });
    if (draw_dialog_buttons("Send", !sender.work().is_running(), edits, "Close"))
        send(settings, edits);
}
