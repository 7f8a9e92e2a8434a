#include "ui/library/thumbnail_row.h"

#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cmath>

float thumbnail_row_height() {
    return std::floor(ImGui::GetFontSize() * 1.75f);
}

namespace {
// The middle of the picture, cropped to the shape of the frame.
void draw_view_image(const ViewImage& image, const ImVec2& low, const ImVec2& high) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, theme::packed(theme::surround));
    if (image.handle == 0)
        return list.AddRect(low, high, theme::packed(theme::line));
    const float shape = (high.x - low.x) / (high.y - low.y);
    const float own = static_cast<float>(image.extent.width) /
                      static_cast<float>(std::max(image.extent.height, 1));
    const float x = own > shape ? 0.5f * (1.0f - shape / own) : 0.0f;
    const float y = own < shape ? 0.5f * (1.0f - own / shape) : 0.0f;
    list.AddImage(texture_id(image.handle), low, high, {x, 1.0f - y}, {1.0f - x, y});
}

bool draw_star(bool is_on, const ImVec2& low, float side) {
    ImGui::SetCursorScreenPos(low);
    const bool is_pressed = ImGui::InvisibleButton("##star", {side, side});
    const bool is_hovered = ImGui::IsItemHovered();
    const float size = std::round(ImGui::GetFontSize() * 0.8f);
    const float inset = std::floor((side - size) * 0.5f);
    draw_icon(is_on ? Icon::star : Icon::star_outline, {low.x + inset, low.y + inset}, size,
              theme::packed(is_on || is_hovered ? theme::accent : theme::label));
    tooltip(is_on ? "Favourite. Click to remove it from the favourites." : "Add to favourites");
    return is_pressed;
}
}  // namespace

RowClick draw_thumbnail_row(const ThumbnailRow& row, const Scene& scene, Edits& edits) {
    const float height = thumbnail_row_height();
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    RowClick click;
    click.is_row = ImGui::Selectable("##row", row.is_open, ImGuiSelectableFlags_AllowItemOverlap,
                                     {width, height});
    tooltip(row.about);
    const ImVec2 next = ImGui::GetCursorScreenPos();
    const bool is_hovered = ImGui::IsMouseHoveringRect(low, {low.x + width, low.y + height}) &&
                            ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    const float inset = std::floor(2.0f * scene.scale);
    const float image_height = height - 2.0f * inset;
    const float image_width = std::floor(image_height * 16.0f / 9.0f);
    draw_view_image(row.image, {low.x + inset, low.y + inset},
                    {low.x + inset + image_width, low.y + inset + image_height});
    const bool shows_star = row.star && (*row.star || is_hovered);
    const float left = low.x + image_width + inset + ImGui::GetFontSize() * 0.55f;
    const float mark = row.is_modified ? ImGui::CalcTextSize(" •").x : 0.0f;
    const float room = low.x + width - left - mark - (shows_star ? height : 4.0f * scene.scale);
    const std::string text = elided_to_width(row.label, room) + (row.is_modified ? " •" : "");
    ImGui::GetWindowDrawList()->AddText(
        {left, std::floor(low.y + 0.5f * (height - ImGui::GetFontSize()))},
        theme::packed(row.is_open ? theme::accent : theme::text), text.c_str());
    if (shows_star) {
        click.is_star = draw_star(*row.star, {low.x + width - height, low.y}, height);
        edits.mark(row.star_mark);
        ImGui::SetCursorScreenPos(next);
    }
    return click;
}

namespace {
// The top of a row within the list; negative: it is not there.
float top_of(const std::vector<std::string>& ids, const std::string& id) {
    const auto found = std::ranges::find(ids, id);
    return found == ids.end() ? -1.0f
                              : static_cast<float>(found - ids.begin()) * thumbnail_row_height();
}

// Explicit, so that the list can scroll in the frame that adds rows, and further than its last row.
void set_content_height(float rows, float scroll) {
    const float shown = scroll > 0.0f ? scroll + ImGui::GetContentRegionAvail().y : 0.0f;
    ImGui::SetNextWindowContentSize({0.0f, std::max(rows, shown)});
}

void show_row(float top) {
    const float room = ImGui::GetWindowHeight();
    const float scroll = ImGui::GetScrollY();
    if (top < scroll || top + thumbnail_row_height() > scroll + room)
        ImGui::SetScrollY(top - 0.5f * (room - thumbnail_row_height()));
}

// A dialog elsewhere, such as the one that saves a preset, leaves no window under the pointer.
bool is_pointed() {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    return (!g.HoveredWindow || g.HoveredWindow == g.CurrentWindow) &&
           g.CurrentWindow->OuterRectClipped.Contains(g.IO.MousePos);
}

ListAnchor anchor_at_pointer(const ThumbnailList& list) {
    ListAnchor now;
    now.open = list.open;
    const float pointed = ImGui::GetMousePos().y - ImGui::GetCursorScreenPos().y;
    const float row = std::floor(pointed / thumbnail_row_height());
    if (!is_pointed() || row < 0.0f || row >= static_cast<float>(list.ids.size()))
        return now;
    now.hovered = list.ids[static_cast<std::size_t>(row)];
    now.top = row * thumbnail_row_height();
    now.scroll = ImGui::GetScrollY();
    return now;
}
}  // namespace

void begin_thumbnail_list(const ThumbnailList& list, ListAnchor ScrolledTo::*anchor,
                          const Scene& scene, Edits& edits) {
    const ListAnchor& before = scene.window.scrolled.*anchor;
    const float rows = static_cast<float>(list.ids.size()) * thumbnail_row_height();
    const float top = before.hovered.empty() ? -1.0f : top_of(list.ids, before.hovered);
    const float scroll = top < 0.0f ? 0.0f : before.scroll + top - before.top;
    set_content_height(rows, scroll);
    if (top >= 0.0f && top != before.top)
        ImGui::SetNextWindowScroll({-1.0f, std::max(scroll, 0.0f)});
    ImGui::BeginChild(list.name.c_str(), {0.0f, 0.0f}, false, ImGuiWindowFlags_NavFlattened);
    const ListAnchor now = anchor_at_pointer(list);
    if (before.open != list.open && now.hovered.empty() && top_of(list.ids, list.open) >= 0.0f)
        show_row(top_of(list.ids, list.open));
    if (now != before)
        edits.arrange([now, anchor](WindowState& window) { window.scrolled.*anchor = now; });
}
