#include "ui/window/layout.h"

#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"

#include <algorithm>
#include <array>

namespace {
constexpr float pane_gap = 4.0f;
constexpr float transport_height = 38.0f;
constexpr float status_height = 25.0f;

// Reduces two requested sizes by the same factor until at least `rest` of `room` remains.
std::array<float, 2> shared(float first, float second, float room, float rest) {
    const float maximum = std::max(0.0f, room - rest);
    const float wanted = first + second;
    const float factor = wanted > maximum && wanted > 0.0f ? maximum / wanted : 1.0f;
    return {first * factor, second * factor};
}

bool is_used(PanelPlace place, const WindowLayout& window) {
    return window.panels.shown_in(place).has_value();
}

void arrange_right(const WindowLayout& window, const Rect& column, float scale, Layout& layout) {
    if (!is_used(PanelPlace::lower_right, window)) {
        layout.panels[PanelPlace::right] = column;
        return;
    }
    Rect lower = column;
    if (is_used(PanelPlace::right, window)) {
        const float wanted = window.sizes.inspector * scale;
        const float gap = pane_gap * scale;
        lower.height = std::clamp(wanted, column.height * 0.2f, column.height * 0.5f);
        lower.top = column.bottom() - lower.height;
        layout.panels[PanelPlace::right] = {column.left, column.top, column.width,
                                            column.height - lower.height - gap};
    }
    layout.panels[PanelPlace::lower_right] = lower;
}

void arrange_middle(const WindowLayout& window, const Rect& column, float scale, Layout& layout) {
    const float between = pane_gap * scale;
    layout.transport = {column.left, column.top, column.width, transport_height * scale};
    const float top = layout.transport.bottom() + between;
    const float room = column.bottom() - top;
    const auto [strip, bottom] =
        shared(is_used(PanelPlace::strip, window) ? window.sizes.strip * scale + between : 0.0f,
               is_used(PanelPlace::bottom, window) ? window.sizes.bottom * scale + between : 0.0f,
               room, room / 3.0f);
    layout.picture = {column.left, top, column.width, room - strip - bottom};
    if (strip > 0.0f)
        layout.panels[PanelPlace::strip] = {column.left, layout.picture.bottom() + between,
                                            column.width, strip - between};
    if (bottom > 0.0f)
        layout.panels[PanelPlace::bottom] = {column.left, column.bottom() - bottom + between,
                                             column.width, bottom - between};
}

// A splitter between two panes; returns the dragged distance.
float dragged(const char* id, const Rect& bar, bool is_upright) {
    ImGui::SetCursorPos({bar.left, bar.top});
    ImGui::InvisibleButton(id, {std::max(bar.width, 1.0f), std::max(bar.height, 1.0f)});
    if (!ImGui::IsItemHovered() && !ImGui::IsItemActive())
        return 0.0f;
    ImGui::SetMouseCursor(is_upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const theme::Color color = ImGui::IsItemActive() ? theme::accent : theme::accent_filled;
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, theme::packed(color));
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    if (!ImGui::IsItemActive())
        return 0.0f;
    return is_upright ? moved.x : moved.y;
}

void resize(Edits& edits, float PaneSizes::*size, float by) {
    if (by != 0.0f)
        edits.arrange([=](WindowState& window) { resize_pane(window.layout.sizes, size, by); });
}
}  // namespace

Layout arrange_panes(const WindowLayout& window, const Rect& all, float scale) {
    Layout layout;
    if (window.is_picture_only) {
        layout.picture = all;
        return layout;
    }
    const float between = pane_gap * scale;
    layout.status = {all.left, all.bottom() - status_height * scale, all.width,
                     status_height * scale};
    const float height = all.height - layout.status.height - between;
    const bool has_left = is_used(PanelPlace::left, window);
    const bool has_right =
        is_used(PanelPlace::right, window) || is_used(PanelPlace::lower_right, window);
    const auto [left, right] = shared(has_left ? window.sizes.left * scale + between : 0.0f,
                                      has_right ? window.sizes.right * scale + between : 0.0f,
                                      all.width, all.width / 3.0f);
    if (left > 0.0f)
        layout.panels[PanelPlace::left] = {all.left, all.top, left - between, height};
    if (right > 0.0f)
        arrange_right(window, {all.right() - right + between, all.top, right - between, height},
                      scale, layout);
    arrange_middle(window, {all.left + left, all.top, all.width - left - right, height}, scale,
                   layout);
    return layout;
}

void draw_splitters(const Layout& layout, float scale, Edits& edits) {
    const float width = pane_gap * scale;
    const auto pane = [&](PanelPlace place) {
        const auto found = layout.panels.find(place);
        return found == layout.panels.end() ? Rect() : found->second;
    };
    const auto drag_column = [&](const char* id, float left, float PaneSizes::*size, float sign) {
        const Rect bar{left, layout.transport.top, width,
                       layout.status.top - width - layout.transport.top};
        resize(edits, size, sign * dragged(id, bar, true) / scale);
    };
    const auto drag_top = [&](const char* id, const Rect& below, float PaneSizes::*size) {
        const Rect bar{below.left, below.top - width, below.width, width};
        if (below.is_shown())
            resize(edits, size, -dragged(id, bar, false) / scale);
    };
    const Rect left = pane(PanelPlace::left);
    if (left.is_shown())
        drag_column("##left", left.right(), &PaneSizes::left, 1.0f);
    const Rect upper = pane(PanelPlace::right);
    const Rect lower = pane(PanelPlace::lower_right);
    const Rect& right = upper.is_shown() ? upper : lower;
    if (right.is_shown())
        drag_column("##right", right.left - width, &PaneSizes::right, -1.0f);
    drag_top("##strip", pane(PanelPlace::strip), &PaneSizes::strip);
    drag_top("##bottom", pane(PanelPlace::bottom), &PaneSizes::bottom);
    if (upper.is_shown())
        drag_top("##inspector", lower, &PaneSizes::inspector);
}
