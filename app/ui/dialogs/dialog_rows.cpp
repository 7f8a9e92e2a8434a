#include "ui/dialogs/dialog_rows.h"

#include "ui/dialogs/dialog_frame.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <imgui/imgui_stdlib.h>

float dialog_label_width() {
    return ImGui::GetFontSize() * 6.5f;
}

void dialog_row(const char* label) {
    ImGui::AlignTextToFramePadding();
    const ScopedColor color(ImGuiCol_Text, theme::label);
    ImGui::TextUnformatted(label);
    ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + dialog_label_width());
}

void dialog_row_problem(const std::string& text, Edits& edits) {
    if (text.empty())
        return;
    ImGui::SetCursorPosX(ImGui::GetStyle().WindowPadding.x + dialog_label_width());
    draw_dialog_problem(text, edits);
}

std::string dialog_text(const char* id, const std::string& text, const std::string& hint,
                        float width, Edits& edits) {
    std::string typed = text;
    ImGui::SetNextItemWidth(width);
    ImGui::InputTextWithHint(("##" + std::string(id)).c_str(), hint.c_str(), &typed,
                             ImGuiInputTextFlags_AutoSelectAll);
    edits.mark(id);
    return typed;
}

std::size_t dialog_list(const char* id, const std::vector<std::string>& labels, std::size_t chosen,
                        float width, Edits& edits) {
    const std::string current = chosen < labels.size() ? labels[chosen] : "";
    const bool is_open = begin_combo(("##" + std::string(id)).c_str(), current, width);
    if (!is_open) {
        edits.mark(id);
        return chosen;
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const ScopedId scope(static_cast<int>(i));
        if (ImGui::Selectable(labels[i].c_str(), i == chosen))
            chosen = i;
        edits.mark(std::string(id) + ":" + labels[i]);
    }
    ImGui::EndCombo();
    return chosen;
}
