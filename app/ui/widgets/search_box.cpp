#include "ui/widgets/search_box.h"

#include "gpu/input_event.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"

#include <imgui/imgui_stdlib.h>

bool draw_search_box(const SearchBox& box, std::string& text, Edits& edits) {
    const ScopedId id{std::string(box.mark)};
    const bool has_text = !text.empty();
    const float button = has_text ? ImGui::GetFrameHeight() : 0.0f;
    ImGui::SetNextItemWidth(box.width - button);
    if (box.wants_focus)
        ImGui::SetKeyboardFocusHere();
    bool is_changed = ImGui::InputTextWithHint("##text", box.hint, &text);
    edits.mark(box.mark);
    if (box.is_entered) {
        *box.is_entered = ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(gpu::key::enter, false);
        if (*box.is_entered)
            ImGui::SetKeyboardFocusHere(-1);
    }
    // ImGui leaves the field and restores the text that it had when it got the focus.
    const bool is_escaped =
        ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(gpu::key::escape, false);
    if (is_escaped) {
        is_changed = has_text || !text.empty();
        text.clear();
        if (has_text)
            ImGui::SetKeyboardFocusHere(-1);
    }
    if (!has_text)
        return is_changed;
    ImGui::SameLine(0.0f, 0.0f);
    if (icon_button("##clear", Icon::close, "Clear", theme::dim)) {
        text.clear();
        is_changed = true;
    }
    edits.mark(std::string(box.mark) + "_clear");
    return is_changed;
}
