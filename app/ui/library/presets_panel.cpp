#include "ui/library/presets_panel.h"

#include "lab/commands/preset_commands.h"
#include "lab/menus/preset_menu.h"
#include "ui/library/preset_filter.h"
#include "ui/library/preset_menu.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {
/// The size of one cell of the preset grid.
struct PresetCell {
    float width = 0.0f;
    float height = 0.0f;  // of the picture
    float gap = 0.0f;
    float caption = 0.0f;  // height of the text line below
    int columns = 1;
};

PresetCell preset_cell() {
    const float minimum = ImGui::GetFontSize() * 10.0f;
    PresetCell cell{.gap = ImGui::GetFontSize() * 0.6f,
                    .caption = ImGui::GetTextLineHeightWithSpacing() + 2.0f};
    const float room = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
    cell.columns = std::max(1, static_cast<int>((room + cell.gap) / (minimum + cell.gap)));
    const auto columns = static_cast<float>(cell.columns);
    cell.width = std::floor((room + cell.gap) / columns - cell.gap);
    cell.width = std::min(cell.width, minimum * 1.3f);
    cell.height = std::floor(cell.width * 9.0f / 16.0f);
    return cell;
}

void draw_morph_time(const PresetBrowsing& wanted, Edits& edits) {
    ImGui::AlignTextToFramePadding();
    dim_text("Morph in");
    ImGui::SameLine();
    const std::string current = fmt::format("{:g} s", wanted.morph_seconds);
    if (begin_combo("##morph_seconds", current, ImGui::GetFontSize() * 4.4f)) {
        for (const double seconds : morph_lengths) {
            if (ImGui::Selectable(fmt::format("{:g} s", seconds).c_str(),
                                  seconds == wanted.morph_seconds))
                edits.arrange(
                    [seconds](WindowState& window) { window.presets.morph_seconds = seconds; });
            edits.mark(fmt::format("morph_seconds:{:g}", seconds));
        }
        ImGui::EndCombo();
    } else {
        tooltip("Duration of a morph. Shift+click a preset or press Ctrl+Shift+PageDown to morph.");
        edits.mark("morph_seconds");
    }
}

void draw_content_choice(const Scene& scene, Edits& edits) {
    const Look& look = scene.lab.document->look();
    if (look.driven_by == Driver::nothing)
        return;
    ImGui::SameLine();
    const bool has_source = look.driven_by == Driver::picture;
    const std::array labels = has_source ? std::array{"Preset's source", "My source"}
                                         : std::array{"Preset's signal", "My signal"};
    const bool is_own = scene.window.presets.shows_own_content;
    if (begin_combo("##content", labels[is_own ? 1 : 0], ImGui::GetFontSize() * 8.5f)) {
        for (const bool choice : {false, true}) {
            if (ImGui::Selectable(labels[choice ? 1 : 0], choice == is_own))
                edits.arrange(
                    [choice](WindowState& window) { window.presets.shows_own_content = choice; });
            edits.mark(choice ? "pictures_with:mine" : "pictures_with:preset");
        }
        ImGui::EndCombo();
    } else {
        tooltip(has_source ? "Source for the thumbnails: each preset's own or yours."
                           : "Signal for the thumbnails: each preset's own or yours.");
        edits.mark("pictures_with");
    }
}

void draw_count(const Scene& scene, const std::vector<ListedPreset>& listed) {
    const auto due = std::ranges::count_if(listed, [&](const ListedPreset& preset) {
        return scene.pictures.presets.of(preset.preset.entry.file).is_due;
    });
    if (due == 0)
        return;
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    dim_text(fmt::format("{} left to render", due));
}

// The whole picture, centred on a dark background.
void draw_image(const ViewImage& image, const ImVec2& low, const PresetCell& cell) {
    const auto width = static_cast<float>(image.extent.width);
    const auto height = static_cast<float>(image.extent.height);
    const float factor = std::min(cell.width / width, cell.height / height);
    const ImVec2 size(width * factor, height * factor);
    const ImVec2 at(low.x + (cell.width - size.x) * 0.5f, low.y + (cell.height - size.y) * 0.5f);
    ImGui::GetWindowDrawList()->AddImage(
        texture_id(image.handle), at, {at.x + size.x, at.y + size.y}, {0.0f, 1.0f}, {1.0f, 0.0f});
}

// The reason for a missing picture, clipped to the cell.
void draw_why_none(const std::string& problem, const ImVec2& low, const PresetCell& cell) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = ImGui::GetFontSize() * 0.5f;
    const std::string text = problem.empty() ? "…" : problem;
    const ImVec4 clip(low.x, low.y, low.x + cell.width, low.y + cell.height);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + pad, low.y + pad},
                 theme::packed(problem.empty() ? theme::faint : theme::problem), text.c_str(),
                 nullptr, cell.width - 2.0f * pad, &clip);
}

// The star has a dark background, so it is visible on any picture.
bool draw_star(const ListedPreset& preset, const ImVec2& low, const PresetCell& cell) {
    const float side = ImGui::GetFontSize() * 1.6f;
    ImGui::SetCursorScreenPos({low.x + cell.width - side, low.y});
    const bool is_pressed = ImGui::InvisibleButton("##star", {side, side});
    const bool is_hovered = ImGui::IsItemHovered();
    const ImVec2 at = ImGui::GetItemRectMin();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + side, at.y + side}, IM_COL32(0, 0, 0, 160));
    const float size = std::round(ImGui::GetFontSize() * 0.85f);
    const float inset = (side - size) * 0.5f;
    const theme::Color color = is_hovered || preset.has_star ? theme::accent : theme::text;
    draw_icon(preset.has_star ? Icon::star : Icon::star_outline,
              {std::round(at.x + inset), std::round(at.y + inset)}, size, theme::packed(color));
    tooltip(preset.has_star ? "Favourite. Click to remove it from the favourites."
                            : "Add to favourites");
    return is_pressed;
}

void draw_picture(const ListedPreset& preset, const Scene& scene, const ImVec2& low,
                  const PresetCell& cell, bool is_hovered) {
    const ImVec2 high(low.x + cell.width, low.y + cell.height);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, theme::packed(theme::surround));
    const PresetThumbnails::Shown shown = scene.pictures.presets.of(preset.preset.entry.file);
    if (shown.image.handle != 0)
        draw_image(shown.image, low, cell);
    else
        draw_why_none(shown.problem, low, cell);
    if (preset.is_open || is_hovered)
        list.AddRect(low, high, theme::packed(preset.is_open ? theme::accent : theme::faint), 0.0f,
                     0, preset.is_open ? 2.0f : 1.0f);
    const float mark = preset.is_modified ? ImGui::CalcTextSize(" •").x : 0.0f;
    const std::string name = elided_to_width(preset.preset.name, cell.width - mark);
    list.AddText({low.x, high.y + 3.0f},
                 theme::packed(preset.is_open ? theme::accent : theme::text),
                 (name + (preset.is_modified ? " •" : "")).c_str());
}

std::string help_for(const ListedPreset& preset, const Scene& scene) {
    const std::string& about = preset.preset.about;
    return fmt::format(
        "{}\nShift+click to morph to it in {:g} s.",
        about.empty() ? preset.preset.name : fmt::format("{}\n{}", preset.preset.name, about),
        scene.window.presets.morph_seconds);
}

void draw_preset(const ListedPreset& preset, const Scene& scene, const PresetCell& cell,
                 Edits& edits) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 size(cell.width, cell.height + cell.caption);
    const bool is_clicked = ImGui::InvisibleButton("##preset", size);
    ImGui::SetItemAllowOverlap();
    edits.mark("picture:" + preset.preset.entry.id);
    const bool is_hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) ||
                            ImGui::IsMouseHoveringRect(low, {low.x + size.x, low.y + size.y});
    tooltip(help_for(preset, scene));
    draw_preset_menu(preset, scene, edits);
    draw_picture(preset, scene, low, cell, is_hovered);
    bool is_starred = false;
    if (!preset.is_plain() && (preset.has_star || is_hovered)) {
        is_starred = draw_star(preset, low, cell);
        edits.mark("preset_star:" + preset.preset.entry.id);
        ImGui::SetCursorScreenPos({low.x, low.y});
        ImGui::Dummy(size);  // so that the next cell is placed next to the whole cell
    }
    if (is_starred)
        star_listed(preset, edits);
    else if (is_clicked && ImGui::GetIO().KeyShift)
        morph_to_listed(preset, scene, edits);
    else if (is_clicked)
        open_listed(preset, scene, edits, ImGui::GetIO().KeyAlt);
}
}  // namespace

void draw_presets_panel(const Scene& scene, Edits& edits) {
    if (!scene.lab.document)
        return;
    const PresetBrowsing& wanted = scene.window.presets;
    const std::vector<ListedPreset> listed =
        listed_presets(*scene.lab.document, scene.library_view.looks(),
                       scene.lab.presets.navigation().stars(), wanted);
    draw_preset_search({"preset_search", "Search presets", ImGui::GetFontSize() * 11.0f}, wanted,
                       edits);
    ImGui::SameLine();
    draw_star_filter("only_starred", wanted, edits);
    ImGui::SameLine();
    draw_morph_time(wanted, edits);
    draw_content_choice(scene, edits);
    draw_count(scene, listed);
    if (listed.empty())
        return wrapped_dim_text(why_no_preset(wanted));
    ImGui::BeginChild("##pictures", {0.0f, 0.0f}, false, ImGuiWindowFlags_NavFlattened);
    const PresetCell cell = preset_cell();
    for (std::size_t i = 0; i < listed.size(); ++i) {
        const ScopedId id(listed[i].preset.entry.file.string());
        if (i % static_cast<std::size_t>(cell.columns) != 0)
            ImGui::SameLine(0.0f, cell.gap);
        draw_preset(listed[i], scene, cell, edits);
    }
    ImGui::EndChild();
}
