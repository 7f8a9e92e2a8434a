#include "ui/library/history_panel.h"

#include "lab/document/history.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>

namespace {
struct HistoryRow {
    HistoryStep step;
    ViewImage image;
    float height = 0.0f;
    bool is_present = false;
};

theme::Color name_color(const HistoryRow& row) {
    return row.is_present ? theme::accent : row.step.distance > 0 ? theme::dim : theme::text;
}

// The picture in a 16:9 frame, so that all names align.
float draw_image(const HistoryRow& row, const ImVec2& low) {
    const ImVec2 size(row.height * 16.0f / 9.0f, row.height);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, theme::packed(theme::surround));
    const auto width = static_cast<float>(row.image.extent.width);
    const auto height = static_cast<float>(row.image.extent.height);
    if (row.image.handle == 0)
        return size.x;
    const float factor = std::min(size.x / width, size.y / height);
    const ImVec2 shown(width * factor, height * factor);
    const ImVec2 at(low.x + (size.x - shown.x) * 0.5f, low.y + (size.y - shown.y) * 0.5f);
    const float alpha = row.step.distance > 0 ? 0.5f : 1.0f;
    list.AddImage(texture_id(row.image.handle), at, {at.x + shown.x, at.y + shown.y}, {0.0f, 1.0f},
                  {1.0f, 0.0f}, ImGui::GetColorU32({1.0f, 1.0f, 1.0f, alpha}));
    return size.x;
}

// The picture of the step, its name, and its changes below.
bool draw_history_row(const HistoryRow& row) {
    const bool is_clicked = ImGui::Selectable("##step", row.is_present, 0, {0.0f, row.height});
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    tooltip(row.step.details);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = ImGui::GetFontSize() * 0.5f;
    const float start =
        pad + draw_image(row, {low.x + pad, low.y + (high.y - low.y - row.height) * 0.5f});
    const float width = high.x - low.x - start - 2.0f * pad;
    const float line = ImGui::GetFontSize() * 1.15f;
    const float text = row.step.change.empty() ? line : 2.0f * line;
    ImVec2 at(low.x + start + pad, (low.y + high.y - text) * 0.5f);
    list.AddText(at, theme::packed(name_color(row)), elided_to_width(row.step.name, width).c_str());
    at.y += line;
    list.AddText(at, theme::packed(theme::dim), elided_to_width(row.step.change, width).c_str());
    const float left = ImGui::GetWindowPos().x;
    if (row.is_present)
        list.AddRectFilled({left, low.y}, {left + pad * 0.35f, high.y},
                           theme::packed(theme::accent));
    return is_clicked;
}

void draw_head(Edits& edits) {
    heading("History");
    same_line_right(ImGui::GetFrameHeight());
    ImGui::SetCursorPosY(ImGui::GetStyle().WindowPadding.y * 0.5f);
    if (icon_button("##close", Icon::close, "Close", theme::dim))
        edits.arrange([](WindowState& window) { window.layout.panels.hide(panel_id::history); });
    edits.mark("history_close");
    ImGui::SetCursorPosY(ImGui::GetStyle().WindowPadding.y + ImGui::GetFrameHeight());
}

// Scrolls to the current step when the panel opens, and after an edit, undo or redo. Otherwise
// keeps the scroll position.
void follow(const Document& document, const WindowState& window, float height, Edits& edits) {
    const HistoryScroll seen{history_index(document), history_size(document)};
    if (seen == window.scrolled.history && !ImGui::IsWindowAppearing())
        return;
    const float top = height * static_cast<float>(seen.index);
    const float room = ImGui::GetWindowHeight();
    if (top < ImGui::GetScrollY() || top + height > ImGui::GetScrollY() + room)
        ImGui::SetScrollY(std::max(0.0f, top - (room - height) * 0.5f));
    edits.arrange([seen](WindowState& state) { state.scrolled.history = seen; });
}
}  // namespace

void draw_history_panel(const Scene& scene, Edits& edits) {
    draw_head(edits);
    const Document* document = scene.lab.document;
    if (!document)
        return;
    const float between = ImGui::GetStyle().ItemSpacing.y;
    const float height = ImGui::GetFontSize() * 2.7f;
    {  // only for the list: popups above it keep their own padding
        const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::BeginChild("##steps", {0.0f, 0.0f}, false, ImGuiWindowFlags_NavFlattened);
    }
    follow(*document, scene.window, height + between, edits);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(history_size(*document)), height + between);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const ScopedId id(i);
            const auto index = static_cast<std::size_t>(i);
            const HistoryStep step = history_step(*document, index);
            const int distance = step.distance;
            const ViewImage image = scene.pictures.history.picture(*document, index);
            if (draw_history_row({step, image, height, distance == 0}) && distance != 0)
                edits.change([distance](Document& travelling) { travelling.travel(distance); });
            edits.mark("history:" + std::to_string(i));
        }
    ImGui::EndChild();
}
