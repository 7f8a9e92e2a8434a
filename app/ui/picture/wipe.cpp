#include "ui/picture/wipe.h"

#include "ui/picture/picture_menus.h"
#include "ui/widgets/theme.h"

#include <algorithm>

namespace {
constexpr theme::Color shade{0.0f, 0.0f, 0.0f, 0.62f};

// Starts right of `x`, or ends left of it.
void draw_name(const std::string& name, float x, float y, bool is_left, const Scene& scene) {
    const ImVec2 text = ImGui::CalcTextSize(name.c_str());
    const ImVec2 pad(ImGui::GetFontSize() * 0.5f, ImGui::GetFontSize() * 0.2f);
    const float gap = ImGui::GetFontSize() * 0.5f;
    const float left = is_left ? x - gap - text.x - 2.0f * pad.x : x + gap;
    const ImVec2 high(left + text.x + 2.0f * pad.x, y + text.y + 2.0f * pad.y);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({left, y}, high, theme::packed(shade), 4.0f * scene.scale);
    list.AddText({left + pad.x, y + pad.y}, theme::packed(theme::text), name.c_str());
}
}  // namespace

std::optional<WipeLine> drag_wipe(const ImVec2& size, const Scene& scene, Edits& edits) {
    const Extent picture = large_extent(scene);
    const Extent room = device_pixels(scene, size.x, size.y);
    const bool is_wiping = scene.lab.frames.comparison().mode() == CompareMode::wipe;
    if (!is_wiping || scene.lab.frames.comparison().selection().is_reference_shown() ||
        picture.is_empty() || room.is_empty())
        return std::nullopt;
    const ImVec2 start = ImGui::GetCursorPos();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const PicturePosition position = position_of(scene.window.views.large(), picture, room);
    const int column = wipe_column(position, picture, room, scene.window.views.wipe_share);
    const float at = static_cast<float>(column) / scene.density;
    const float grip = ImGui::GetFontSize();
    ImGui::SetCursorPos({start.x + at - grip * 0.5f, start.y});
    ImGui::InvisibleButton("##wipe", {grip, std::max(size.y, 1.0f)});
    edits.mark("wipe");
    const bool is_held = ImGui::IsItemActive() || ImGui::IsItemHovered();
    if (is_held)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive()) {
        const double pointer = (ImGui::GetIO().MousePos.x - low.x) * scene.density;
        const double share = wipe_share(position, picture, room, pointer);
        edits.arrange([share](WindowState& window) { window.views.wipe_share = share; });
    }
    ImGui::SetCursorPos(start);
    return WipeLine{low.x + at, low.y, low.y + size.y, is_held};
}

void draw_wipe(const WipeLine& line, const Scene& scene) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float width = 1.0f / scene.density;
    list.AddRectFilled({line.x - width, line.top}, {line.x + 2.0f * width, line.bottom},
                       theme::packed(shade));
    list.AddRectFilled({line.x, line.top}, {line.x + width, line.bottom},
                       theme::packed(line.is_held ? theme::accent : theme::text));
    const float middle = (line.top + line.bottom) * 0.5f;
    const ImVec2 grip(3.0f * scene.scale, 16.0f * scene.scale);
    list.AddRectFilled({line.x - grip.x, middle - grip.y}, {line.x + grip.x, middle + grip.y},
                       theme::packed(line.is_held ? theme::accent : theme::label), grip.x);
    const float top = line.top + ImGui::GetFontSize() * 0.5f;
    draw_name(scene.lab.frames.comparison().sides()->left_name(), line.x, top, true, scene);
    draw_name(scene.lab.frames.comparison().sides()->right_name(), line.x, top, false, scene);
}

void draw_halves_names(const ImVec2& low, float middle, const Scene& scene) {
    const auto sides = scene.lab.frames.comparison().sides();
    if (!sides)
        return;
    const float top = low.y + ImGui::GetFontSize() * 0.5f;
    if (scene.lab.frames.comparison().selection().is_reference_shown())
        return draw_name(sides->other, low.x, top, false, scene);
    if (scene.views.main().reference().handle == 0)
        return;
    draw_name(sides->left_name(), low.x, top, false, scene);
    draw_name(sides->right_name(), middle, top, false, scene);
}

bool is_over_variant(const std::optional<WipeLine>& line, const Scene& scene) {
    return line && (ImGui::GetIO().MousePos.x < line->x) ==
                       scene.lab.frames.comparison().sides()->is_other_left;
}
