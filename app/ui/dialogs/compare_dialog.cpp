#include "ui/dialogs/compare_dialog.h"

#include "lab/menus/preset_difference.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>

void compare_preset(const ListedLookPreset& preset, const Scene& scene, Edits& edits) {
    if (!scene.lab.document)
        return;
    auto changes =
        difference_from(preset.entry.file, *scene.lab.document, scene.lab.media.recent());
    if (!changes) {
        edits.change(
            [problem = changes.error().front()](Messages& messages) { messages.say(problem); });
        return;
    }
    edits.show({.kind = Dialog::Kind::compare_preset,
                .subject = preset.name,
                .changes = std::move(*changes)});
}

namespace {
void cell(const std::string& text, const theme::Color& color) {
    ImGui::TableNextColumn();
    fitted_text(text, ImGui::GetContentRegionAvail().x, color);
}

void draw_table(const Dialog& dialog, const Scene& scene, Edits& edits) {
    const auto rows = static_cast<float>(dialog.changes.size() + 1);
    const float line = ImGui::GetTextLineHeight() + 2.0f * ImGui::GetStyle().CellPadding.y;
    const float room = ImGui::GetIO().DisplaySize.y * 0.7f;
    const ScopedColor stripe(ImGuiCol_TableRowBgAlt, theme::field);
    const ImVec2 size(0.0f, std::min(rows * line + 2.0f, room));
    if (!ImGui::BeginTable("##changes", 5, ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg, size))
        return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch, 1.0f);
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 1.0f);
    ImGui::TableSetupColumn("preset", ImGuiTableColumnFlags_WidthStretch, 1.0f);
    ImGui::TableSetupColumn("open", ImGuiTableColumnFlags_WidthStretch, 1.0f);
    ImGui::TableSetupColumn("unit", ImGuiTableColumnFlags_WidthStretch, 0.9f);
    ImGui::TableNextRow();
    cell({}, theme::dim);
    cell({}, theme::dim);
    cell(dialog.subject, theme::dim);
    cell("Current", theme::dim);
    cell({}, theme::dim);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(dialog.changes.size()), line);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const Change& change = dialog.changes[static_cast<std::size_t>(i)];
            ImGui::TableNextRow();
            cell(change.label, theme::label);
            edits.mark("change:" + change.label);
            const ScopedFont font(scene.fonts.numbers);
            cell(change.name, theme::dim);
            cell(change.before, theme::text);
            cell(change.after, theme::accent);
            cell(change.unit, theme::dim);
        }
    ImGui::EndTable();
}
}  // namespace

void draw_compare_dialog(const Scene& scene, Edits& edits) {
    const Dialog& dialog = scene.window.dialog;
    const DialogFrame frame("Differences", 58.0f, scene, edits);
    if (!frame.is_open())
        return;
    if (dialog.changes.empty())
        wrapped_dim_text(
            fmt::format("\"{}\" and the current settings are identical.", dialog.subject));
    else
        draw_table(dialog, scene, edits);
    draw_close_button("Close", edits);
}
