#include "ui/library/stack_panel.h"

#include "lab/menus/stack_menu.h"
#include "ui/widgets/form.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/menu_items.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace {
void draw_bypass(const StackPart& part, const std::string& key, const std::string& name,
                 Edits& edits) {
    bool is_drawn = !part.is_bypassed;
    if (ImGui::Checkbox("##drawn", &is_drawn))
        run({bypass_part(part, name)}, edits);
    edits.mark("stack_bypass:" + key);
    tooltip(is_drawn ? "Bypass this look" : "Stop bypassing this look");
}

void draw_move(const char* id, int by, const StackPart& part, const std::string& name,
               bool is_possible, Edits& edits) {
    const ScopedDisabled disabled(!is_possible);
    const bool is_asked = icon_button(id, by < 0 ? Icon::up : Icon::down,
                                      by < 0 ? "Move this look earlier" : "Move this look later",
                                      is_possible ? theme::dim : theme::faint);
    if (is_asked && is_possible)
        run({move_part(part, name, by)}, edits);
}

void draw_part(const Stack& stack, std::size_t i, const std::string& name, Edits& edits) {
    const StackPart& part = stack[i];
    const ScopedId id(part.tag);
    const std::string key = stack_keys(stack)[i];
    const float side = ImGui::GetFrameHeight();
    draw_bypass(part, key, name, edits);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    fitted_text(name, ImGui::GetContentRegionAvail().x - 3.0f * side,
                part.is_bypassed ? theme::dim : theme::text);
    const ScopedStyle<ImVec2> gap(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 2.0f));
    same_line_right(3.0f * side);
    draw_move("##up", -1, part, name, i > 0, edits);
    edits.mark("stack_up:" + key);
    ImGui::SameLine();
    draw_move("##down", 1, part, name, i + 1 < stack.size(), edits);
    edits.mark("stack_down:" + key);
    ImGui::SameLine();
    if (icon_button("##remove", Icon::close, "Remove from the stack", theme::dim))
        run({remove_part(part, name)}, edits);
    edits.mark("stack_remove:" + key);
}

void draw_add(const Scene& scene, Edits& edits) {
    if (begin_combo("##add_look", "Add a look after this one…", form_width())) {
        for (const ListedLook& look : scene.library_view.looks()) {
            if (look.is_stack())
                continue;
            const ScopedId id(look.entry.folder.string());
            if (ImGui::Selectable(look.name.c_str()))
                add_to_stack(look, edits);
            focus_list_item(look.name, false);
            edits.mark("stack_add:" + look.entry.id);
            tooltip(look.about);
        }
        ImGui::EndCombo();
    }
    edits.mark("stack_add");
    tooltip("In a stack, each look processes the picture of the previous one.");
}
}  // namespace

void add_to_stack(const ListedLook& look, Edits& edits) {
    run({add_part(look)}, edits);
}

void draw_stack_panel(const Scene& scene, Edits& edits) {
    const Document* document = scene.lab.document;
    if (!document)
        return;
    heading("Stack");
    const Stack& stack = document->state().stack;
    const std::vector<std::string> names = part_names(stack, scene.library_view.looks());
    for (std::size_t i = 0; has_stack_menu(stack) && i < stack.size(); ++i)
        draw_part(stack, i, names[i], edits);
    draw_add(scene, edits);
    ImGui::Spacing();
}
