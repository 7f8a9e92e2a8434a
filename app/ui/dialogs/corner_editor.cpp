#include "ui/dialogs/corner_editor.h"

#include "gpu/input_event.h"
#include "lab/jobs/background_jobs.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <imgui/imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {
constexpr float rest_of_dialog = 16.0f;  // font sizes around the photo
constexpr float magnifier = 14.0f;       // font sizes
constexpr float radius = 6.0f;

// Where the photo is on the screen.
struct ShownPhoto {
    ImVec2 low;
    ImVec2 size;
    float scale;  // per px of the photo

    ImVec2 at(glm::dvec2 position) const {
        return {low.x + scale * static_cast<float>(position.x),
                low.y + scale * static_cast<float>(position.y)};
    }
    glm::dvec2 photo_at(ImVec2 point) const {
        return {static_cast<double>((point.x - low.x) / scale),
                static_cast<double>((point.y - low.y) / scale)};
    }
};

ShownPhoto fitted_photo(Extent photo, ImVec2 room) {
    const auto width = static_cast<float>(photo.width);
    const auto height = static_cast<float>(photo.height);
    const float least = 8.0f * ImGui::GetFontSize();
    const float scale = std::min(std::max(room.x, least) / width, std::max(room.y, least) / height);
    return {ImGui::GetCursorScreenPos(),
            {std::floor(scale * width), std::floor(scale * height)},
            scale};
}

void draw_photo(const PhotoMatcher::OpenPhoto& photo, const ShownPhoto& shown) {
    ImGui::GetWindowDrawList()->AddImage(texture_id(photo.texture.handle()), shown.low,
                                         {shown.low.x + shown.size.x, shown.low.y + shown.size.y},
                                         {0.0f, 1.0f}, {1.0f, 0.0f});
    ImGui::InvisibleButton("##corners", shown.size);
}

std::size_t nearest(const Corners& corners, const ShownPhoto& shown, ImVec2 point) {
    std::array<float, 4> distances{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const ImVec2 at = shown.at(corners[i]);
        distances[i] = std::hypot(at.x - point.x, at.y - point.y);
    }
    return static_cast<std::size_t>(std::ranges::min_element(distances) - distances.begin());
}

void draw_outline(const Corners& corners, const ShownPhoto& shown, std::size_t chosen) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 accent = ImGui::GetColorU32(theme::accent);
    for (std::size_t i = 0; i < corners.size(); ++i)
        list.AddLine(shown.at(corners[i]), shown.at(corners[(i + 1) % 4]), accent, 1.5f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const ImVec2 at = shown.at(corners[i]);
        list.AddCircle(at, radius, IM_COL32(0, 0, 0, 255), 0, 4.0f);
        list.AddCircle(at, radius, accent, 0, i == chosen ? 3.0f : 1.5f);
    }
}

void draw_magnifier(const PhotoMatcher& matcher, glm::dvec2 corner, float side) {
    if (!matcher.magnified())
        return;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 to(from.x + side, from.y + side);
    ImGui::Image(texture_id(matcher.magnified()->handle()), {side, side}, {0.0f, 1.0f},
                 {1.0f, 0.0f});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRect(from, to, ImGui::GetColorU32(theme::line));
    const glm::dvec2 inside = corner - glm::floor(corner);
    const float pixel = side / static_cast<float>(PhotoMatcher::magnified_side);
    const ImVec2 at(from.x + 0.5f * side + pixel * static_cast<float>(inside.x),
                    from.y + 0.5f * side + pixel * static_cast<float>(inside.y));
    const ImU32 accent = ImGui::GetColorU32(theme::accent);
    list.AddLine({from.x, at.y}, {to.x, at.y}, accent);
    list.AddLine({at.x, from.y}, {at.x, to.y}, accent);
}

void move_by_keys(const Corners& corners, std::size_t chosen, Edits& edits) {
    const double step = ImGui::GetIO().KeyShift ? 1.0 : 0.1;
    glm::dvec2 move(0.0);
    for (const auto& [key, by] : {std::pair{ImGuiKey_LeftArrow, glm::dvec2(-1.0, 0.0)},
                                  std::pair{ImGuiKey_RightArrow, glm::dvec2(1.0, 0.0)},
                                  std::pair{ImGuiKey_UpArrow, glm::dvec2(0.0, -1.0)},
                                  std::pair{ImGuiKey_DownArrow, glm::dvec2(0.0, 1.0)}})
        if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)))
            move += step * by;
    if (move == glm::dvec2(0.0))
        return;
    edits.change([chosen, to = corners[chosen] + move](BackgroundJobs& jobs) {
        jobs.matcher().move_corner(chosen, to);
    });
}
}  // namespace

void draw_corner_editor(const PhotoMatcher& matcher, Edits& edits) {
    const auto& photo = matcher.photo();
    if (!photo)
        return;
    const float font = ImGui::GetFontSize();
    const float side_column = magnifier * font + ImGui::GetStyle().ItemSpacing.x;
    const ShownPhoto shown = fitted_photo(photo->picture->extent,
                                          {ImGui::GetContentRegionAvail().x - side_column,
                                           ImGui::GetIO().DisplaySize.y - rest_of_dialog * font});
    draw_photo(*photo, shown);
    edits.mark("match_photo");
    int& last = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("##corner"), 0);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsItemActivated())
        last = static_cast<int>(nearest(photo->corners, shown, mouse));
    const auto chosen = static_cast<std::size_t>(last);
    if (ImGui::IsItemActive())
        edits.change([chosen, to = shown.photo_at(mouse)](BackgroundJobs& jobs) {
            jobs.matcher().move_corner(chosen, to);
        });
    else
        move_by_keys(photo->corners, chosen, edits);
    draw_outline(photo->corners, shown, chosen);
    ImGui::SameLine();
    ImGui::BeginGroup();
    draw_magnifier(matcher, photo->corners[chosen], magnifier * font);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + magnifier * font);
    dim_text("Arrow keys move the corner by 0.1 px, with Shift by 1 px.");
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
}
