#include "ui/library/library_panel.h"

#include "lab/commands/preset_commands.h"
#include "lab/document/opened_preset.h"
#include "ui/library/preset_menu.h"
#include "ui/library/stack_panel.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace {
struct Line {
    std::string label;
    std::string about;
    bool is_open = false;
    bool is_modified = false;
};

// A line of the list; true when clicked.
bool draw_line(const Line& line) {
    const ScopedId id(line.label);
    const ImVec2 at = ImGui::GetCursorPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const bool is_clicked = ImGui::Selectable("##line", line.is_open);
    tooltip(line.about);
    const float mark = line.is_modified ? ImGui::CalcTextSize(" •").x : 0.0f;
    const std::string text = elided_to_width(line.label, width - mark - 4.0f);
    ImGui::SetCursorPos({at.x + 4.0f, at.y});
    const ScopedColor color(ImGuiCol_Text, line.is_open ? theme::accent : theme::text);
    ImGui::TextUnformatted((text + (line.is_modified ? " •" : "")).c_str());
    return is_clicked;
}

void draw_presets(const ListedLook& look, const Scene& scene, Edits& edits) {
    const Document& document = *scene.lab.document;
    const float indent = ImGui::GetStyle().IndentSpacing;
    ImGui::Indent(indent);
    const bool has_none = preset_file(document).empty();
    if (draw_line({.label = "Default",
                   .about = "All parameters at their defaults.",
                   .is_open = has_none,
                   .is_modified = has_none && is_modified(document)}))
        edits.open(look.argument());
    edits.mark("preset:");
    const bool has_both = !look.presets.empty() && !look.presets.front().entry.is_shipped &&
                          look.presets.back().entry.is_shipped;
    for (const ListedLookPreset& preset : look.presets) {
        const bool is_first = &preset == &look.presets.front() ||
                              (&preset - 1)->entry.is_shipped != preset.entry.is_shipped;
        if (is_first && (has_both || !preset.entry.is_shipped)) {
            ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 4.0f);
            dim_text(preset.entry.is_shipped ? "Shipped" : "Yours");
        }
        const ListedPreset listed =
            as_listed(preset, document, scene.lab.presets.navigation().stars());
        const ScopedId id(preset.entry.file.string());
        ImGui::BeginGroup();
        const bool is_clicked = draw_line({.label = preset.name,
                                           .about = preset.about,
                                           .is_open = listed.is_open,
                                           .is_modified = listed.is_modified});
        ImGui::EndGroup();
        edits.mark("preset:" + preset.entry.id);
        draw_preset_menu(listed, scene, edits);
        if (is_clicked)
            open_listed(listed, scene, edits, ImGui::GetIO().KeyAlt);
    }
    ImGui::Unindent(indent);
}

void draw_look_menu(const ListedLook& look, const Scene& scene, Edits& edits) {
    if (!ImGui::BeginPopupContextItem("##look_menu"))
        return;
    if (ImGui::MenuItem("Open"))
        edits.open(look.argument());
    if (!look.is_stack() && scene.lab.document && ImGui::MenuItem("Append to the stack"))
        add_to_stack(look, edits);
    ImGui::EndPopup();
}
}  // namespace

void draw_library_panel(const Scene& scene, Edits& edits) {
    const Document* document = scene.lab.document;
    heading("Looks");
    for (const ListedLook& look : scene.library_view.looks()) {
        const ScopedId id(look.argument());
        const bool is_open = document && is_listed_as(document->look(), look);
        bool is_clicked = false;
        {
            const ScopedFont font(is_open ? scene.fonts.strong : scene.fonts.text);
            ImGui::BeginGroup();
            is_clicked = draw_line({.label = look.name, .about = look.about});
            ImGui::EndGroup();
            edits.mark("look:" + look.entry.id);
        }
        draw_look_menu(look, scene, edits);
        if (is_clicked && !is_open)
            edits.open(look.argument());
        if (is_open)
            draw_presets(look, scene, edits);
    }
    if (scene.library_view.looks().empty())
        dim_text("No looks found.");
}
