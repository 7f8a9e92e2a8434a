#include "ui/dialogs/palette_dialog.h"

#include "gpu/input_event.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/palette_list.h"
#include "ui/frame/action_name.h"
#include "ui/widgets/remote_menu.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <imgui/imgui_internal.h>
#include <imgui/imgui_stdlib.h>

#include <algorithm>

namespace {
constexpr int rows_shown = 12;

// Whether the menu of a row is open. The keys then belong to it.
bool is_row_menu_open() {
    return ImGui::GetCurrentContext()->OpenPopupStack.Size > 1;
}

// The typed text, including the input of this frame.
std::string draw_query(const Dialog& dialog, float width, Edits& edits) {
    std::string text = dialog.text;
    ImGui::SetNextItemWidth(width);
    if (dialog.is_new || (!ImGui::IsAnyItemActive() && !is_row_menu_open()))
        ImGui::SetKeyboardFocusHere();
    if (ImGui::InputTextWithHint("##query", "Find commands, looks, presets, passes or parameters",
                                 &text))
        edits.arrange([text](WindowState& window) {
            window.dialog.text = text;
            window.dialog.chosen = 0;
        });
    edits.mark("palette_query");
    return text;
}

// The selected row after the key presses of this frame.
int moved_choice(int chosen, int count, Edits& edits) {
    const int before = chosen;
    if (is_row_menu_open())
        return std::clamp(chosen, 0, std::max(count - 1, 0));
    const auto move = [&](int key, int by) {
        if (ImGui::IsKeyPressed(key))
            chosen += by;
    };
    move(gpu::key::down, 1);
    move(gpu::key::up, -1);
    move(gpu::key::page_down, rows_shown - 1);
    move(gpu::key::page_up, 1 - rows_shown);
    chosen = std::clamp(chosen, 0, std::max(count - 1, 0));
    if (chosen != before)
        edits.arrange([chosen](WindowState& window) { window.dialog.chosen = chosen; });
    return chosen;
}

struct PaletteRow {
    const PaletteEntry& entry;
    const std::vector<std::size_t>& positions;
    bool is_chosen = false;
    float width = 0.0f;
};

// Draws a label with its matched letters in the accent colour. Returns the x at its end.
float draw_label(const PaletteRow& row, ImVec2 at) {
    const std::string& label = row.entry.label;
    const theme::Color plain = row.entry.disabled_reason.empty() ? theme::text : theme::faint;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto fits = [&row](std::size_t index) {
        return std::binary_search(row.positions.begin(), row.positions.end(), index);
    };
    for (std::size_t start = 0, end = 0; start < label.size(); start = end) {
        const bool is_fit = fits(start);
        while (end < label.size() && fits(end) == is_fit)
            ++end;
        const char* first = label.data() + start;
        const char* last = label.data() + end;
        const bool is_lit = is_fit && row.entry.disabled_reason.empty();
        list.AddText(at, theme::packed(is_lit ? theme::accent : plain), first, last);
        at.x += ImGui::CalcTextSize(first, last).x;
    }
    return at.x;
}

bool draw_palette_row(const PaletteRow& row) {
    const bool is_clicked = ImGui::Selectable("##row", row.is_chosen);
    const ImVec2 low = ImGui::GetItemRectMin();
    const float pad = ImGui::GetFontSize() * 0.4f;
    const ImVec2 at(low.x + pad, low.y + (ImGui::GetItemRectSize().y - ImGui::GetFontSize()) / 2);
    const float end = draw_label(row, at) + ImGui::GetFontSize();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string& keys = row.entry.keys;
    const bool is_off = !row.entry.disabled_reason.empty();
    const float keys_at = low.x + row.width - pad - ImGui::CalcTextSize(keys.c_str()).x;
    list.AddText({keys_at, at.y}, theme::packed(is_off ? theme::faint : theme::label),
                 keys.c_str());
    const std::string& text = is_off ? row.entry.disabled_reason : row.entry.detail;
    const std::string cut = elided_to_width(text, keys_at - end - ImGui::GetFontSize());
    list.AddText({end, at.y}, theme::packed(theme::dim), cut.c_str());
    return is_clicked;
}

// The command of an entry for OSC and MIDI; "": none.
RemoteItem remote_item(const PaletteEntry& entry, const Scene& scene) {
    if (entry.kind == PaletteEntry::Kind::action)
        for (const Action& action : scene.actions.rows())
            if (action.label == entry.id)
                return {action_command(action), action.label};
    if (entry.kind == PaletteEntry::Kind::preset)
        for (const ListedLook& look : scene.library_view.looks())
            for (const ListedLookPreset& preset : look.presets)
                if (preset.entry.file == entry.subject)
                    return {fmt::format("preset/{}/{}", preset.entry.look, preset.entry.id),
                            preset.name};
    return {};
}

// The clicked row; -1: none.
int draw_rows(const std::vector<PaletteEntry>& entries, const std::vector<PaletteMatch>& matches,
              int chosen, bool follows, const Scene& scene, Edits& edits) {
    const float height = ImGui::GetTextLineHeightWithSpacing();
    const float shown = height * static_cast<float>(rows_shown);
    const float top = height * static_cast<float>(chosen);
    if (follows && top < ImGui::GetScrollY())
        ImGui::SetScrollY(top);
    if (follows && top + height > ImGui::GetScrollY() + shown)
        ImGui::SetScrollY(top + height - shown);
    int clicked = -1;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(matches.size()), height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const ScopedId id(i);
            const PaletteMatch& match = matches[static_cast<std::size_t>(i)];
            const PaletteEntry& entry = entries[match.entry];
            if (draw_palette_row(
                    {entry, match.positions, i == chosen, ImGui::GetContentRegionAvail().x}))
                clicked = i;
            edits.mark("palette:" + entry.label);
            const RemoteItem item = remote_item(entry, scene);
            if (!item.command.empty() &&
                draw_remote_menu(item, scene, edits) == RemoteChoice::learn)
                close_dialog(edits);
        }
    return clicked;
}

void draw_palette(const Scene& scene, float width, Edits& edits) {
    const Dialog& dialog = scene.window.dialog;
    const std::string query = draw_query(dialog, width, edits);
    const std::vector<PaletteEntry> entries = palette_list(scene);
    const std::vector<PaletteMatch> matches =
        find_entries(entries, query, scene.window.recent.commands);
    const int first = query == dialog.text ? dialog.chosen : 0;
    const int chosen = moved_choice(first, static_cast<int>(matches.size()), edits);
    const float row = ImGui::GetTextLineHeightWithSpacing();
    const int rows = std::clamp(static_cast<int>(matches.size()), 1, rows_shown);
    ImGui::BeginChild("##rows", {width, row * static_cast<float>(rows)});
    const bool follows = chosen != dialog.chosen || query != dialog.text;
    int asked = draw_rows(entries, matches, chosen, follows, scene, edits);
    if (matches.empty())
        dim_text("No matches.");
    ImGui::EndChild();
    if (is_row_menu_open())
        return;
    if (ImGui::IsKeyPressed(gpu::key::enter, false) ||
        ImGui::IsKeyPressed(gpu::key::pad_enter, false))
        asked = chosen;
    if (ImGui::IsKeyPressed(gpu::key::escape, false))
        close_dialog(edits);
    if (asked < 0 || asked >= static_cast<int>(matches.size()))
        return;
    const PaletteEntry& entry = entries[matches[static_cast<std::size_t>(asked)].entry];
    if (!entry.disabled_reason.empty())
        return;
    close_dialog(edits);
    run(entry, scene, edits);
}
}  // namespace

void draw_palette_dialog(const Scene& scene, Edits& edits) {
    constexpr const char* id = "##palette";
    if (scene.window.dialog.is_new) {
        ImGui::OpenPopup(id);
        edits.arrange([](WindowState& window) { window.dialog.is_new = false; });
    }
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const float width = std::min(40.0f * ImGui::GetFontSize(), room.x * 0.9f);
    ImGui::SetNextWindowPos({room.x * 0.5f, room.y * 0.1f}, ImGuiCond_Always, {0.5f, 0.0f});
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding,
                                      ImVec2(10.0f * scene.scale, 10.0f * scene.scale));
    const ScopedStyle<float> rounding(ImGuiStyleVar_PopupRounding, 6.0f * scene.scale);
    const ScopedStyle<float> edge(ImGuiStyleVar_PopupBorderSize, 1.0f);
    const ScopedColor line(ImGuiCol_Border, theme::faint);
    if (!ImGui::BeginPopup(id, ImGuiWindowFlags_NoMove)) {
        close_dialog(edits);  // clicked outside
        return;
    }
    draw_palette(scene, width, edits);
    ImGui::EndPopup();
}
