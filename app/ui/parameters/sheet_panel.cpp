#include "ui/parameters/sheet_panel.h"

#include "lab/menus/parameter_menu.h"
#include "lab/previews/previews.h"
#include "ui/parameters/parameter_help.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/menu_items.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
void show_sheet(const SheetRequest& request, Edits& edits) {
    run(sheet_commands(request), edits);
}

// "Bloom · Intensity". Labels alone are not unique.
std::string long_label(const Parameter& parameter) {
    return parameter.group.empty() ? parameter.label
                                   : fmt::format("{} · {}", parameter.group, parameter.label);
}

std::string label_of(const Look& look, const std::string& name) {
    const Parameter* parameter = find_parameter(look, name);
    return parameter ? long_label(*parameter) : name;
}

// A list of the parameters that can be varied; "": no parameter.
bool draw_parameter_choice(const char* id, const Look& look, std::string& chosen, Edits& edits) {
    const std::string before = chosen;
    const float width = ImGui::GetFontSize() * 11.0f;
    const std::string label = chosen.empty() ? "None" : label_of(look, chosen);
    if (!begin_combo(id, label, width))
        return false;
    if (ImGui::Selectable("None", chosen.empty()))
        chosen.clear();
    for (const Parameter& parameter : look.parameters) {
        const ScopedId scope(parameter.name);
        if (!can_be_varied(parameter) || parameter.is_hidden)
            continue;
        if (ImGui::Selectable(long_label(parameter).c_str(), parameter.name == chosen))
            chosen = parameter.name;
        focus_list_item(long_label(parameter), parameter.name == chosen);
        edits.mark("sheet_choice:" + parameter.name);
    }
    ImGui::EndCombo();
    return chosen != before;
}

bool draw_count_choice(const char* id, int& count, Edits& edits) {
    const int before = count;
    if (!begin_combo(id, std::to_string(count), ImGui::GetFontSize() * 3.6f))
        return false;
    for (const int choice : sheet_counts) {
        if (ImGui::Selectable(std::to_string(choice).c_str(), choice == count))
            count = choice;
        edits.mark(fmt::format("sheet_count:{}", choice));
    }
    ImGui::EndCombo();
    return count != before;
}

void draw_progress(const VariantSheet& sheet, Edits& edits) {
    if (!sheet.is_running())
        return;
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const std::string count = fmt::format("{} of {}", sheet.drawn(), sheet.cells().size());
    const std::string whole =
        fmt::format("{} of {} rendered · Esc to stop", sheet.drawn(), sheet.cells().size());
    const bool is_wide = ImGui::CalcTextSize(whole.c_str()).x <= ImGui::GetContentRegionAvail().x;
    dim_text(is_wide ? whole : count);
    edits.mark("sheet_progress");
    if (!is_wide)
        tooltip(whole);
}

void draw_head(const VariantSheet& sheet, const Look& look, Edits& edits) {
    SheetRequest request = sheet.request();
    bool is_changed = false;
    ImGui::AlignTextToFramePadding();
    dim_text("Columns");
    ImGui::SameLine();
    is_changed |= draw_parameter_choice("##across", look, request.across, edits);
    edits.mark("sheet_across");
    ImGui::SameLine();
    is_changed |= draw_count_choice("##columns", request.columns, edits);
    edits.mark("sheet_columns");
    ImGui::SameLine();
    dim_text("Rows");
    ImGui::SameLine();
    is_changed |= draw_parameter_choice("##down", look, request.down, edits);
    edits.mark("sheet_down");
    if (!request.down.empty()) {
        ImGui::SameLine();
        is_changed |= draw_count_choice("##rows", request.rows, edits);
        edits.mark("sheet_rows");
    }
    draw_progress(sheet, edits);
    if (request.down == request.across)
        request.down.clear();
    if (is_changed)
        show_sheet(request, edits);
}

/// Layout of the pictures in the available space.
struct Grid {
    int columns = 1;
    float width = 0.0f;  // of a picture
    float height = 0.0f;
    float gap = 0.0f;
    float text_height = 0.0f;  // of the line below
};

Grid grid_for(const VariantSheet& sheet, Extent picture) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const auto count = static_cast<float>(sheet.cells().size());
    Grid grid{.columns = sheet.columns(),
              .gap = ImGui::GetFontSize() * 0.5f,
              .text_height = ImGui::GetTextLineHeightWithSpacing()};
    const auto columns = static_cast<float>(grid.columns);
    const float rows = std::ceil(count / columns);
    const float aspect =
        static_cast<float>(picture.width) / static_cast<float>(std::max(picture.height, 1));
    const float by_width = (room.x - ImGui::GetStyle().ScrollbarSize) / columns - grid.gap;
    const float by_height = (room.y / rows - grid.text_height - grid.gap) * aspect;
    const float minimum = ImGui::GetFontSize() * 6.0f;
    grid.width = std::floor(std::max(std::min(by_width, by_height), std::min(minimum, by_width)));
    grid.height = std::floor(grid.width / aspect);
    return grid;
}

std::string text_of(const SweepCell& cell, const Look& look) {
    std::string text;
    for (const auto& [name, value] : cell.values)
        if (const Parameter* parameter = find_parameter(look, name))
            text += (text.empty() ? "" : " · ") + short_value(*parameter, value);
    return text;
}

void draw_cell(const VariantSheet::Cell& cell, bool is_present, const Grid& grid,
               const Look& look) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high(low.x + grid.width, low.y + grid.height);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, theme::packed(theme::surround));
    if (cell.picture)
        list.AddImage(texture_id(cell.picture->texture().handle()), low, high, {0.0f, 1.0f},
                      {1.0f, 0.0f});
    const bool is_hovered = ImGui::IsItemHovered();
    if (is_present || is_hovered)
        list.AddRect(low, high, theme::packed(is_present ? theme::accent : theme::faint), 0.0f, 0,
                     is_present ? 2.0f : 1.0f);
    const std::string text = elided_to_width(text_of(cell.values, look), grid.width);
    list.AddText({low.x, high.y + 2.0f}, theme::packed(is_present ? theme::accent : theme::label),
                 text.c_str());
}

void draw_cells(const VariantSheet& sheet, const Scene& scene, Edits& edits) {
    const Document& document = *scene.lab.document;
    const Grid grid = grid_for(sheet, scene.lab.size.extent());
    const auto current = sheet.current(document);
    for (std::size_t i = 0; i < sheet.cells().size(); ++i) {
        const VariantSheet::Cell& cell = sheet.cells()[i];
        const ScopedId id(static_cast<int>(i));
        if (i % static_cast<std::size_t>(grid.columns) != 0)
            ImGui::SameLine(0.0f, grid.gap);
        if (ImGui::InvisibleButton("##cell", {grid.width, grid.height + grid.text_height}))
            edits.change(
                [i](Previews& previews, Document& changed) { previews.sheet().apply(i, changed); });
        edits.mark(fmt::format("cell:{}", i));
        tooltip(cell.values.caption);
        draw_cell(cell, i == current, grid, document.look());
    }
}
}  // namespace

void draw_sheet_panel(const Scene& scene, Edits& edits) {
    if (!scene.lab.document)
        return;
    const VariantSheet& sheet = scene.lab.frames.previews().sheet();
    draw_head(sheet, scene.lab.document->look(), edits);
    if (!sheet.problem().empty()) {
        const ScopedColor color(ImGuiCol_Text, theme::warning);
        ImGui::TextWrapped("%s", sheet.problem().c_str());
        edits.mark("sheet_problem");
    } else if (sheet.request().across.empty()) {
        wrapped_dim_text(
            "Choose a parameter to render the picture at several values of its slider. Click a "
            "picture to apply its values. A second parameter adds rows with all combinations.");
    } else {
        draw_cells(sheet, scene, edits);
    }
}

void draw_sheet_items(const ParameterEntry& entry, Edits& edits) {
    const std::string& name = entry.parameter.name;
    if (!can_be_varied(entry.parameter))
        return;
    if (ImGui::MenuItem("Filmstrip of this parameter"))
        show_sheet({.across = name}, edits);
    edits.mark("filmstrip");
}

void leave_hidden_sheet(const Scene& scene, Edits& edits) {
    if (!scene.window.layout.sees(panel_id::sheet) &&
        scene.lab.frames.previews().sheet().is_running())
        edits.change([](Previews& previews) { previews.sheet().cancel(); });
}
