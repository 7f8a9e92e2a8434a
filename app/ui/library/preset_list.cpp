#include "ui/library/preset_list.h"

#include "lab/commands/preset_commands.h"
#include "lab/document/opened_preset.h"
#include "ui/library/preset_filter.h"
#include "ui/library/preset_menu.h"
#include "ui/library/thumbnail_row.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

namespace {
void draw_preset_head(const Scene& scene, Edits& edits) {
    ImGui::AlignTextToFramePadding();
    dim_text("Presets");
    ImGui::SameLine();
    const float width = ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight();
    draw_preset_search({"preset_list_search", "Search", width}, scene.window.presets, edits);
    ImGui::SameLine(0.0f, 0.0f);
    draw_star_filter("list_starred", scene.window.presets, edits);
}

// Without the pictures of presets that were never drawn, a row shows an empty frame.
// `spacing`: of the menu's items.
void draw_preset(const ListedLookPreset& preset, const ImVec2& spacing, const Scene& scene,
                 Edits& edits) {
    const ListedPreset listed =
        as_listed(preset, *scene.lab.document, scene.lab.presets.navigation().stars());
    const ScopedId id(preset.entry.file.string());
    const std::string kind = listed.is_plain() || preset.entry.is_shipped ? "" : "\nYour preset.";
    ImGui::BeginGroup();
    const RowClick click = draw_thumbnail_row(
        {.label = preset.name,
         .about = fmt::format("{}{}{}{}", preset.name, preset.about.empty() ? "" : "\n",
                              preset.about, kind),
         .image = scene.pictures.presets.of(preset.entry.file).image,
         .is_open = listed.is_open,
         .is_modified = listed.is_modified,
         .star = listed.is_plain() ? std::nullopt : std::optional(listed.has_star),
         .star_mark = "list_star:" + preset.entry.id},
        scene, edits);
    ImGui::EndGroup();
    edits.mark("preset:" + preset.entry.id);
    {
        const ScopedStyle<ImVec2> gap(ImGuiStyleVar_ItemSpacing, spacing);
        draw_preset_menu(listed, scene, edits);
    }
    if (click.is_star)
        star_listed(listed, edits);
    else if (click.is_row && ImGui::GetIO().KeyShift)
        morph_to_listed(listed, scene, edits);
    else if (click.is_row)
        open_listed(listed, scene, edits, ImGui::GetIO().KeyAlt);
}

bool begins_group(const std::vector<ListedLookPreset>& presets, std::size_t index) {
    if (index == 0)
        return false;
    const PresetEntry& before = presets[index - 1].entry;
    const PresetEntry& now = presets[index].entry;
    return before.file.empty() || before.is_shipped != now.is_shipped;
}

// A line between the groups: default, the user's, the shipped presets.
void draw_group_line() {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine(at, {at.x + ImGui::GetContentRegionAvail().x, at.y},
                                        theme::packed(theme::line));
}

void draw_rows(const std::vector<ListedLookPreset>& presets, const Scene& scene, Edits& edits) {
    const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
    const ScopedStyle<ImVec2> no_gap(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 0.0f));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(presets.size()), thumbnail_row_height());
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto index = static_cast<std::size_t>(i);
            if (begins_group(presets, index))
                draw_group_line();
            draw_preset(presets[index], spacing, scene, edits);
        }
    clipper.End();
}
}  // namespace

void draw_preset_list(const Scene& scene, Edits& edits) {
    if (!scene.lab.document)
        return dim_text("Presets");
    draw_preset_head(scene, edits);
    const Document& document = *scene.lab.document;
    const std::vector<ListedLookPreset> presets =
        matching_presets(document.look(), scene.library_view.looks(),
                         scene.lab.presets.navigation().stars(), scene.window.presets);
    if (presets.empty())
        return wrapped_dim_text(why_no_preset(scene.window.presets));
    ThumbnailList list{"##presets " + document.look().id, {}, preset_file(document).string()};
    for (const ListedLookPreset& preset : presets)
        list.ids.push_back(preset.entry.file.string());
    begin_thumbnail_list(list, &ScrolledTo::presets, scene, edits);
    draw_rows(presets, scene, edits);
    ImGui::EndChild();
    edits.mark("preset_rows");
}
