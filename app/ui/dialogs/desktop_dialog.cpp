#include "ui/dialogs/desktop_dialog.h"

#include "ui/dialogs/dialog_frame.h"
#include "ui/widgets/widgets.h"

namespace {
// Moves to the line of the dialog's buttons, at the left. Return to the returned position before
// these are drawn.
ImVec2 start_of_buttons() {
    const ImVec2 at = ImGui::GetCursorPos();
    ImGui::SetCursorPosY(at.y + ImGui::GetStyle().ItemSpacing.y);
    return at;
}
}  // namespace

void draw_desktop_dialog(const Scene& scene, Edits& edits) {
    const FileDialogKind* kind = file_dialog_kind(scene.window.dialog.kind);
    const DialogFrame frame(kind->title, 30.0f, scene, edits);
    if (!frame.is_open())
        return;
    wrapped_dim_text("The desktop's file dialog is open in a separate window.");
    const ImVec2 at = start_of_buttons();
    if (ImGui::Button("Use Afterglow's dialog"))
        edits.arrange([](WindowState& window) {
            window.dialog.host = Dialog::Host::own;
            window.dialog.is_new = true;
        });
    edits.mark("own_dialog");
    ImGui::SetCursorPos(at);
    draw_close_button("Cancel", edits, false);
}

void draw_desktop_switch(const Scene& scene, Edits& edits) {
    if (!scene.window.file_dialogs.has_desktop)
        return;
    const ImVec2 at = start_of_buttons();
    if (quiet_button("Use the desktop's dialog"))
        edits.arrange([](WindowState& window) {
            window.file_dialogs.uses_desktop = true;
            window.dialog.host = Dialog::Host::undecided;
            window.dialog.is_new = true;
        });
    edits.mark("desktop_dialog");
    ImGui::SetCursorPos(at);
}
