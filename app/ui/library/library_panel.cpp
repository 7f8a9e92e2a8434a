#include "ui/library/library_panel.h"

#include "lab/window/look_list.h"
#include "ui/library/stack_panel.h"
#include "ui/library/thumbnail_row.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/search_box.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace {
void draw_look_menu(const ListedLook& look, const Scene& scene, Edits& edits) {
    if (!ImGui::BeginPopupContextItem("##look_menu"))
        return;
    if (ImGui::MenuItem("Open"))
        edits.open(look.argument());
    if (!look.is_stack() && scene.lab.document && ImGui::MenuItem("Append to the stack"))
        add_to_stack(look, edits);
    ImGui::EndPopup();
}

// `spacing`: of the menu's items.
void draw_look(const ListedLook& look, const ImVec2& spacing, const Scene& scene, Edits& edits) {
    const Document* document = scene.lab.document;
    const ScopedId id(look.argument());
    const bool is_open = document && is_listed_as(document->look(), look);
    const RowClick click =
        draw_thumbnail_row({.label = look.name,
                            .about = look.about.empty() ? look.name : look.name + "\n" + look.about,
                            .image = scene.pictures.looks.of(picture_folder(look, scene.roots)),
                            .is_open = is_open},
                           scene, edits);
    edits.mark("look:" + look.entry.id);
    {
        const ScopedStyle<ImVec2> gap(ImGuiStyleVar_ItemSpacing, spacing);
        draw_look_menu(look, scene, edits);
    }
    if (click.is_row && !is_open)
        edits.open(look.argument());
}

// A button with an arrow that opens a menu.
bool arrow_button(const char* id, float side) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const bool is_pressed = ImGui::InvisibleButton(id, {side, side});
    draw_chevron({low.x + 0.5f * side, low.y + 0.5f * side}, true,
                 ImGui::IsItemHovered() ? theme::text : theme::dim);
    return is_pressed;
}

void draw_recent(const Scene& scene, Edits& edits) {
    if (arrow_button("##recent", ImGui::GetFrameHeight()))
        ImGui::OpenPopup("##recent_looks");
    tooltip("Recent looks");
    edits.mark("recent_looks");
    if (!ImGui::BeginPopup("##recent_looks"))
        return;
    const std::string open =
        scene.lab.document ? argument_of(scene.lab.document->look()) : std::string();
    const std::vector<RecentLook> recent =
        recent_looks(scene.window.recent.looks, scene.library_view.looks(), open);
    if (recent.empty())
        dim_text("No other recent looks.");
    for (const RecentLook& look : recent) {
        const ScopedId id(look.argument);
        if (ImGui::MenuItem(menu_label(look.name).c_str()))
            edits.open(look.argument);
        edits.mark("recent_look:" + look.name);
    }
    ImGui::EndPopup();
}

void draw_look_head(const Scene& scene, Edits& edits) {
    ImGui::AlignTextToFramePadding();
    dim_text("Looks");
    ImGui::SameLine();
    const float button = ImGui::GetFrameHeight();
    const float width = ImGui::GetContentRegionAvail().x - button;
    std::string search = scene.window.looks.search;
    if (draw_search_box({"look_search", "Search", width}, search, edits))
        edits.arrange([search](WindowState& window) { window.looks.search = search; });
    ImGui::SameLine(0.0f, 0.0f);
    draw_recent(scene, edits);
}
void draw_rows(const std::vector<const ListedLook*>& looks, const Scene& scene, Edits& edits) {
    const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
    const ScopedStyle<ImVec2> no_gap(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(looks.size()), thumbnail_row_height());
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw_look(*looks[static_cast<std::size_t>(i)], spacing, scene, edits);
    clipper.End();
    if (looks.empty())
        wrapped_dim_text(scene.library_view.looks().empty() ? "No looks found." : "No matches.");
}
}  // namespace

void draw_library_panel(const Scene& scene, Edits& edits) {
    draw_look_head(scene, edits);
    const std::vector<const ListedLook*> looks =
        matching_looks(scene.library_view.looks(), scene.window.looks.search);
    ThumbnailList list{"##looks", {}, {}};
    for (const ListedLook* look : looks)
        list.ids.push_back(look->argument());
    if (scene.lab.document)
        list.open = argument_of(scene.lab.document->look());
    begin_thumbnail_list(list, &ScrolledTo::looks, scene, edits);
    draw_rows(looks, scene, edits);
    ImGui::EndChild();
    edits.mark("look_rows");
}
