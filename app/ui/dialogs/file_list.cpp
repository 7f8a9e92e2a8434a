#include "ui/dialogs/file_list.h"

#include "base/printable.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <array>

namespace {
/// A column of the list. Widths are multiples of the font size.
struct Column {
    const char* label;
    FileOrder::Key key;
    float width;     // 0: the remaining width
    float min_list;  // the column is left out in narrower lists
};
constexpr std::array columns{Column{"Name", FileOrder::Key::name, 0.0f, 0.0f},
                             Column{"Size", FileOrder::Key::size, 5.0f, 18.0f},
                             Column{"Modified", FileOrder::Key::modified, 9.5f, 28.0f}};

bool is_right_aligned(const Column& column) {
    return column.key == FileOrder::Key::size;
}

std::vector<Column> shown_columns(float width) {
    std::vector<Column> shown;
    for (const Column& column : columns)
        if (width >= column.min_list * ImGui::GetFontSize())
            shown.push_back(column);
    return shown;
}

void draw_sort_mark(const Column& column, bool is_descending) {
    const float size = ImGui::GetFontSize();
    const float text = ImGui::CalcTextSize(column.label).x + size * 0.7f;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float x = is_right_aligned(column) ? high.x - text : low.x + text;
    const float middle = (low.y + high.y) * 0.5f;
    const float up = is_descending ? 1.0f : -1.0f;
    ImGui::GetWindowDrawList()->AddTriangleFilled({x - size * 0.22f, middle - up * size * 0.12f},
                                                  {x + size * 0.22f, middle - up * size * 0.12f},
                                                  {x, middle + up * size * 0.16f},
                                                  theme::packed(theme::dim));
}

void draw_headings(const std::vector<Column>& shown, const FileOrder& order, Edits& edits) {
    ImGui::TableNextRow();
    for (std::size_t i = 0; i < shown.size(); ++i) {
        ImGui::TableSetColumnIndex(static_cast<int>(i));
        const bool is_sorted = order.key == shown[i].key;
        const ScopedColor color(ImGuiCol_Text, is_sorted ? theme::text : theme::dim);
        const ScopedStyle<ImVec2> align(ImGuiStyleVar_SelectableTextAlign,
                                        ImVec2(is_right_aligned(shown[i]) ? 1.0f : 0.0f, 0.0f));
        if (ImGui::Selectable(shown[i].label, false, ImGuiSelectableFlags_DontClosePopups))
            edits.arrange([next = FileOrder{shown[i].key, is_sorted && !order.is_descending}](
                              WindowState& window) { window.file_dialogs.order = next; });
        edits.mark(std::string("sort:") + shown[i].label);
        if (is_sorted)
            draw_sort_mark(shown[i], order.is_descending);
    }
}

void draw_folder_icon(const ImVec2& at, float size) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = theme::packed(theme::accent);
    list.AddRectFilled({at.x, at.y + size * 0.16f}, {at.x + size * 0.42f, at.y + size * 0.4f},
                       color, size * 0.08f);
    list.AddRectFilled({at.x, at.y + size * 0.27f}, {at.x + size * 0.92f, at.y + size * 0.86f},
                       color, size * 0.08f);
}

std::string cell_text(const FolderEntry& row, FileOrder::Key key) {
    if (key == FileOrder::Key::modified)
        return modified_text(row.modified);
    return row.is_folder ? std::string() : file_size_text(row.bytes);
}

void draw_cells(const FolderEntry& row, const std::vector<Column>& shown) {
    const float size = ImGui::GetFontSize();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (row.is_folder)
        draw_folder_icon(at, size);
    ImGui::SetCursorScreenPos({at.x + size * 1.3f, at.y});
    fitted_text(printable(row.name), ImGui::GetContentRegionAvail().x, theme::text);
    for (std::size_t i = 1; i < shown.size(); ++i) {
        ImGui::TableSetColumnIndex(static_cast<int>(i));
        const std::string text = cell_text(row, shown[i].key);
        if (is_right_aligned(shown[i]))
            ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x -
                                 ImGui::CalcTextSize(text.c_str()).x);
        dim_text(text);
    }
}

std::optional<FileListClick> draw_row(const FolderEntry& row, bool is_highlighted,
                                      const std::vector<Column>& shown, Edits& edits) {
    ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(0);
    const ScopedId id(row.name);
    const ImVec2 at = ImGui::GetCursorPos();
    const bool is_clicked = ImGui::Selectable("##row", is_highlighted,
                                              ImGuiSelectableFlags_SpanAllColumns |
                                                  ImGuiSelectableFlags_AllowDoubleClick |
                                                  ImGuiSelectableFlags_DontClosePopups);
    // Dear ImGui counts two quick double clicks at one place as four clicks, and the fourth does
    // not press an item. It opens a file that has appeared under the pointer.
    const int clicks = ImGui::GetMouseClickedCount(0);
    const bool is_double = ImGui::IsItemHovered() && clicks > 0 && clicks % 2 == 0;
    edits.mark("file:" + row.name);
    ImGui::SetCursorPos(at);
    draw_cells(row, shown);
    return is_clicked || is_double ? std::optional(FileListClick{row, is_double}) : std::nullopt;
}

void scroll_to(const FileList& list, float height) {
    const auto row = std::ranges::find(list.rows, list.highlighted, &FolderEntry::name);
    if (!list.shows_highlighted || row == list.rows.end())
        return;
    const float top = static_cast<float>(row - list.rows.begin()) * height;
    const float room = ImGui::GetWindowHeight() - 2.0f * height;  // below the headings
    if (top < ImGui::GetScrollY())
        ImGui::SetScrollY(top);
    else if (top > ImGui::GetScrollY() + room - height)
        ImGui::SetScrollY(top - room + height);
}

void set_up(const std::vector<Column>& shown) {
    ImGui::TableSetupScrollFreeze(0, 1);
    for (const Column& column : shown)
        ImGui::TableSetupColumn(column.label,
                                column.width == 0.0f ? ImGuiTableColumnFlags_WidthStretch
                                                     : ImGuiTableColumnFlags_WidthFixed,
                                column.width * ImGui::GetFontSize());
}
}  // namespace

std::optional<FileListClick> draw_file_list(const FileList& list, const ImVec2& size,
                                            const Scene& scene, Edits& edits) {
    std::optional<FileListClick> click;
    const ScopedColor back(ImGuiCol_ChildBg, theme::surround);
    const ScopedColor head(ImGuiCol_TableHeaderBg, theme::surround);
    const ScopedStyle<ImVec2> cells(ImGuiStyleVar_CellPadding,
                                    ImVec2(6.0f * scene.scale, 2.0f * scene.scale));
    const std::vector<Column> shown = shown_columns(size.x);
    if (!ImGui::BeginTable("##entries", static_cast<int>(shown.size()),
                           ImGuiTableFlags_ScrollY | ImGuiTableFlags_NoSavedSettings |
                               ImGuiTableFlags_NoBordersInBody | ImGuiTableFlags_PadOuterX,
                           size))
        return click;
    set_up(shown);
    draw_headings(shown, scene.window.file_dialogs.order, edits);
    const float row_height = ImGui::GetTextLineHeight() + 4.0f * scene.scale;
    scroll_to(list, row_height);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(list.rows.size()), row_height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const FolderEntry& row = list.rows[static_cast<std::size_t>(i)];
            if (const auto clicked = draw_row(row, row.name == list.highlighted, shown, edits))
                click = clicked;
        }
    if (list.rows.empty()) {
        ImGui::TableNextRow();
        ImGui::TableSetColumnIndex(0);
        wrapped_dim_text(list.problem);
        edits.mark("files_problem");
    }
    ImGui::EndTable();
    return click;
}
