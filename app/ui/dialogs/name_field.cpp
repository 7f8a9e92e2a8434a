#include "ui/dialogs/name_field.h"

#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

std::string draw_name_field(const Scene& scene, Edits& edits) {
    std::string text = scene.window.dialog.text;
    if (scene.window.dialog.is_new) {
        ImGui::SetKeyboardFocusHere();
        edits.arrange([](WindowState& window) { window.dialog.is_new = false; });
    }
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::InputText("##name", &text, ImGuiInputTextFlags_AutoSelectAll))
        edits.arrange([text](WindowState& window) {
            window.dialog.text = text;
            window.dialog.problem.clear();
        });
    edits.mark("dialog_name");
    return text;
}

void replace_name(const std::string& name, Edits& edits) {
    edits.arrange([name](WindowState& window) {
        window.dialog.text = name;
        window.dialog.problem.clear();
        window.dialog.is_new = true;  // focuses the field
    });
}
