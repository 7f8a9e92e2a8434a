#include "ui/dialogs/name_field.h"

#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"

#include <imgui/imgui.h>
#include <imgui/imgui_stdlib.h>

std::string draw_name_field(const std::string& proposed, const Scene& scene, Edits& edits) {
    const bool is_new = scene.window.dialog.is_new;
    std::string text = is_new ? proposed : scene.window.dialog.text;
    if (is_new)
        ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    const bool is_typed = ImGui::InputText("##name", &text, ImGuiInputTextFlags_AutoSelectAll);
    edits.mark("dialog_name");
    if (is_new || is_typed)
        edits.arrange([text](WindowState& window) {
            window.dialog.text = text;
            window.dialog.problem.clear();
            window.dialog.is_new = false;
        });
    return text;
}

void draw_name_problem(const std::string& problem, Edits& edits) {
    const ScopedColor color(ImGuiCol_Text, theme::warning);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(problem.empty() ? " " : problem.c_str());
    ImGui::PopTextWrapPos();
    if (!problem.empty())
        edits.mark("dialog_problem");
}
