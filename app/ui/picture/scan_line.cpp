#include "ui/picture/scan_line.h"

#include "ui/picture/picture_menus.h"
#include "ui/widgets/theme.h"

#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace {
bool has_scan_line(const Scene& scene) {
    return scene.window.layout.sees(panel_id::waveform) && !large_extent(scene).is_empty();
}

/// Converts between relative positions in the picture and window coordinates.
struct Ground {
    ImVec2 low;
    PicturePosition position;
    Extent picture;
    float density = 1.0f;

    ImVec2 at(const Pin& pin) const {
        return {low.x + static_cast<float>(position.left + pin.x * picture.width * position.zoom) /
                            density,
                low.y + static_cast<float>(position.top + pin.y * picture.height * position.zoom) /
                            density};
    }
    Pin pin(const ImVec2& point) const {
        const auto share = [](double length, double whole) {
            return std::clamp(length / whole, 0.0, 1.0);
        };
        return {share((point.x - low.x) * density - position.left, picture.width * position.zoom),
                share((point.y - low.y) * density - position.top, picture.height * position.zoom)};
    }
};

Ground ground_at(const ImVec2& low, const ImVec2& size, const Scene& scene) {
    const Extent picture = large_extent(scene);
    const Extent room = device_pixels(scene, size.x, size.y);
    return {low, position_of(scene.window.views.large(), picture, room), picture, scene.density};
}

void set_line(const ScanLine& line, Edits& edits) {
    edits.arrange([line](WindowState& window) { window.probes.scan_line = line; });
}

// Moves the whole line with the pointer, limited to the picture.
ScanLine moved_line(const ScanLine& line, const Ground& ground) {
    const ImVec2 way = ImGui::GetIO().MouseDelta;
    const auto step = [](double by, double a, double b) {
        return std::clamp(by, -std::min(a, b), 1.0 - std::max(a, b));
    };
    const double scale = ground.density / ground.position.zoom;
    const double x = step(way.x * scale / ground.picture.width, line.start.x, line.end.x);
    const double y = step(way.y * scale / ground.picture.height, line.start.y, line.end.y);
    return {{line.start.x + x, line.start.y + y}, {line.end.x + x, line.end.y + y}};
}

// A handle around a point; returns whether it is dragged.
bool is_held(const char* id, const ImVec2& at, const ImVec2& start, const ImVec2& low) {
    const float grip = ImGui::GetFontSize() * 1.2f;
    ImGui::SetCursorPos(
        {start.x + at.x - low.x - grip * 0.5f, start.y + at.y - low.y - grip * 0.5f});
    ImGui::InvisibleButton(id, {grip, grip});
    if (ImGui::IsItemActive() || ImGui::IsItemHovered())
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    return ImGui::IsItemActive();
}

// Shift+drag draws a new line from the start of the drag to the pointer.
void draw_anew(const ImVec2& size, const Ground& ground, Edits& edits) {
    const bool is_drawing = ImGui::GetActiveID() == ImGui::GetID("##new_line");
    if (!ImGui::GetIO().KeyShift && !is_drawing)
        return;
    ImGui::InvisibleButton("##new_line", {std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left))
        set_line({ground.pin(io.MouseClickedPos[0]), ground.pin(io.MousePos)}, edits);
}

ImVec2 between(const ImVec2& from, const ImVec2& to, double share) {
    const auto part = static_cast<float>(share);
    return {from.x + (to.x - from.x) * part, from.y + (to.y - from.y) * part};
}
}  // namespace

void drag_scan_line(const ImVec2& size, const Scene& scene, Edits& edits) {
    if (!has_scan_line(scene))
        return;
    const ImVec2 start = ImGui::GetCursorPos();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const Ground ground = ground_at(low, size, scene);
    const ScanLine& line = scene.window.probes.scan_line;
    const ImVec2 from = ground.at(line.start);
    const ImVec2 to = ground.at(line.end);
    const Pin pointer = ground.pin(ImGui::GetIO().MousePos);
    if (is_held("##line_start", from, start, low))
        set_line({pointer, line.end}, edits);
    edits.mark("line_start");
    if (is_held("##line_end", to, start, low))
        set_line({line.start, pointer}, edits);
    edits.mark("line_end");
    if (is_held("##line_middle", between(from, to, 0.5), start, low))
        set_line(moved_line(line, ground), edits);
    edits.mark("line_middle");
    ImGui::SetCursorPos(start);
    draw_anew(size, ground, edits);
    ImGui::SetCursorPos(start);
}

void draw_scan_line(const ImVec2& low, const ImVec2& size, const Scene& scene) {
    if (!has_scan_line(scene))
        return;
    const Ground ground = ground_at(low, size, scene);
    const ImVec2 from = ground.at(scene.window.probes.scan_line.start);
    const ImVec2 to = ground.at(scene.window.probes.scan_line.end);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(low, {low.x + size.x, low.y + size.y}, true);
    const float radius = 4.0f * scene.scale;
    for (const auto& [color, shift] :
         {std::pair{theme::surround, 1.0f}, std::pair{theme::accent, 0.0f}}) {
        const ImU32 ink = theme::packed(color);
        const ImVec2 a(from.x + shift, from.y + shift);
        const ImVec2 b(to.x + shift, to.y + shift);
        list.AddLine(a, b, ink, 1.0f);
        list.AddCircleFilled(a, radius, ink, 16);
        list.AddCircle(b, radius, ink, 16, 1.5f);
        const ImVec2 middle = between(a, b, 0.5);
        list.AddRectFilled({middle.x - radius, middle.y - 0.5f * radius},
                           {middle.x + radius, middle.y + 0.5f * radius}, ink);
        if (const auto& position = scene.window.probes.scan_position)
            list.AddCircle(between(a, b, *position), 1.5f * radius, ink, 16, 1.5f);
    }
    list.PopClipRect();
}
