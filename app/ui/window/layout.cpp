#include "ui/window/layout.h"

#include "lab/window/pane_sizes.h"
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
    const float most = std::max(0.0f, room - rest);
    const float wanted = first + second;
    const float factor = wanted > most && wanted > 0.0f ? most / wanted : 1.0f;
    return {first * factor, second * factor};
}

void arrange_right(const WindowState& window, const Rect& column, float scale, Layout& layout) {
    layout.parameters = column;
    if (!window.shows_parameters) {
        layout.inspector = column;
        layout.parameters = {};
    } else if (window.shows_inspector) {
        const float wanted = window.panes.inspector * scale;
        const float height = std::clamp(wanted, column.height * 0.2f, column.height * 0.5f);
        layout.parameters.height = column.height - height - pane_gap * scale;
        layout.inspector = {column.left, layout.parameters.bottom() + pane_gap * scale,
                            column.width, height};
    }
}

void arrange_middle(const WindowState& window, const Rect& column, float scale, Layout& layout) {
    const float between = pane_gap * scale;
    layout.transport = {column.left, column.top, column.width, transport_height * scale};
    const float top = layout.transport.bottom() + between;
    const float room = column.bottom() - top;
    const auto [strip, bottom] = shared(
        window.shows_strip ? window.panes.strip * scale + between : 0.0f,
        window.shows_bottom ? window.panes.bottom * scale + between : 0.0f, room, room / 3.0f);
    layout.picture = {column.left, top, column.width, room - strip - bottom};
    if (strip > 0.0f)
        layout.strip = {column.left, layout.picture.bottom() + between, column.width,
                        strip - between};
    if (bottom > 0.0f)
        layout.bottom = {column.left, column.bottom() - bottom + between, column.width,
                         bottom - between};
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
        edits.arrange([=](WindowState& window) { resize_pane(window.panes, size, by); });
}
}  // namespace

Layout arrange_panes(const WindowState& window, const Rect& all, float scale) {
    Layout layout;
    if (window.is_picture_only) {
        layout.picture = all;
        return layout;
    }
    const float between = pane_gap * scale;
    layout.status = {all.left, all.bottom() - status_height * scale, all.width,
                     status_height * scale};
    const float height = all.height - layout.status.height - between;
    const bool has_right = window.shows_parameters || window.shows_inspector;
    const auto [left, right] = shared(
        window.shows_library || window.shows_history ? window.panes.left * scale + between : 0.0f,
        has_right ? window.panes.right * scale + between : 0.0f, all.width, all.width / 3.0f);
    if (left > 0.0f)
        layout.library = {all.left, all.top, left - between, height};
    if (right > 0.0f)
        arrange_right(window, {all.right() - right + between, all.top, right - between, height},
                      scale, layout);
    arrange_middle(window, {all.left + left, all.top, all.width - left - right, height}, scale,
                   layout);
    return layout;
}

void draw_splitters(const Layout& layout, const WindowState& window, float scale, Edits& edits) {
    if (window.is_picture_only)
        return;
    const float width = pane_gap * scale;
    const auto upright = [&](float left) {
        return Rect{left, layout.transport.top, width,
                    layout.status.top - width - layout.transport.top};
    };
    if (layout.library.is_shown()) {
        const float by = dragged("##left", upright(layout.library.right()), true);
        resize(edits, &PaneSizes::left, by / scale);
    }
    const Rect& right = layout.parameters.is_shown() ? layout.parameters : layout.inspector;
    if (right.is_shown()) {
        const float by = dragged("##right", upright(right.left - width), true);
        resize(edits, &PaneSizes::right, -by / scale);
    }
    if (layout.strip.is_shown()) {
        const Rect& strip = layout.strip;
        const float by =
            dragged("##strip", {strip.left, strip.top - width, strip.width, width}, false);
        resize(edits, &PaneSizes::strip, -by / scale);
    }
    if (layout.bottom.is_shown()) {
        const Rect& bottom = layout.bottom;
        const float by =
            dragged("##bottom", {bottom.left, bottom.top - width, bottom.width, width}, false);
        resize(edits, &PaneSizes::bottom, -by / scale);
    }
    if (layout.inspector.is_shown() && layout.parameters.is_shown()) {
        const Rect& pane = layout.inspector;
        const float by =
            dragged("##inspector", {pane.left, pane.top - width, pane.width, width}, false);
        resize(edits, &PaneSizes::inspector, -by / scale);
    }
}
