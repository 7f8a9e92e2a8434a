#include "ui/parameters/parameter_marks.h"

#include "lab/document/document.h"
#include "lab/document/parameter_edits.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <cmath>

namespace {
float mark_width() {
    return std::round(ImGui::GetFontSize() * 1.15f);
}

std::string star_help(const ParameterSetting& setting) {
    return setting.is_favourite ? "Favourite. Click to remove it from the favourites."
                                : "Add to favourites. The filter above can show only favourites.";
}

std::string lock_help(const ParameterSetting& setting) {
    return setting.is_locked ? "Locked. Presets, Randomise and resetting a group or all parameters "
                               "don't change it. Click to unlock."
                             : "Lock. Presets, Randomise and resetting a group or all parameters "
                               "then don't change it.";
}

void change(const ParameterEntry& entry, bool ParameterSetting::*mark, Edits& edits) {
    ParameterSetting next = entry.setting;
    next.*mark = !(next.*mark);
    edits.change([name = entry.parameter.name, next](Document& document) {
        set_parameter_setting(document, name, next);
    });
}

// An icon button that is less prominent than a normal button.
bool draw_mark(const char* id, Icon icon, bool is_set, const std::string& help) {
    const float width = mark_width();
    const float height = ImGui::GetFrameHeight();
    const bool is_pressed = ImGui::InvisibleButton(id, {width, height});
    const ImVec2 low = ImGui::GetItemRectMin();
    const float size = std::round(ImGui::GetFontSize() * 0.78f);
    const theme::Color color = ImGui::IsItemHovered() ? theme::accent
                               : is_set               ? theme::label
                                                      : theme::faint;
    draw_icon(
        icon,
        {low.x + std::round((width - size) * 0.5f), low.y + std::round((height - size) * 0.5f)},
        size, theme::packed(color));
    tooltip(help);
    return is_pressed;
}
// Whether the pointer is in the area, and not dragging from elsewhere.
bool is_under_pointer(const ImVec2& low, const ImVec2& high) {
    const ImVec2 taken = ImGui::GetIO().MouseClickedPos[0];
    const bool is_elsewhere = ImGui::IsMouseDown(0) && !(taken.x >= low.x && taken.x < high.x &&
                                                         taken.y >= low.y && taken.y < high.y);
    return !is_elsewhere && ImGui::IsMouseHoveringRect(low, high) &&
           ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}
}  // namespace

FormColumns ParameterMarks::reduced(FormColumns columns) const {
    columns.label -= width;
    return columns;
}

ParameterMarks parameter_marks(const ParameterSetting& setting, const FormColumns& columns) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high(low.x + columns.label, low.y + ImGui::GetFrameHeight());
    const bool is_pointed_at = is_under_pointer(low, high);
    ParameterMarks marks;
    marks.shows_star = setting.is_favourite || is_pointed_at;
    marks.shows_lock = setting.is_locked || is_pointed_at;
    marks.width = mark_width() * (marks.shows_star ? 2.0f : marks.shows_lock ? 1.0f : 0.0f);
    marks.left = high.x - 2.0f * mark_width();
    return marks;
}

void draw_parameter_marks(const ParameterEntry& entry, const ParameterMarks& marks, Edits& edits) {
    const std::string& name = entry.parameter.name;
    const ParameterSetting& setting = entry.setting;
    const float origin = ImGui::GetWindowPos().x - ImGui::GetScrollX();
    if (marks.shows_star) {
        ImGui::SameLine(marks.left - origin);
        if (draw_mark("##star", setting.is_favourite ? Icon::star : Icon::star_outline,
                      setting.is_favourite, star_help(setting)))
            change(entry, &ParameterSetting::is_favourite, edits);
        edits.mark("star:" + name);
    }
    if (marks.shows_lock) {
        ImGui::SameLine(marks.left + mark_width() - origin);
        if (draw_mark("##lock", setting.is_locked ? Icon::locked : Icon::unlocked,
                      setting.is_locked, lock_help(setting)))
            change(entry, &ParameterSetting::is_locked, edits);
        edits.mark("lock:" + name);
    }
}

void draw_parameter_items(const ParameterEntry& entry, Edits& edits) {
    if (ImGui::MenuItem("Favourite", nullptr, entry.setting.is_favourite))
        change(entry, &ParameterSetting::is_favourite, edits);
    edits.mark("favourite_item");
    if (ImGui::MenuItem("Locked", nullptr, entry.setting.is_locked))
        change(entry, &ParameterSetting::is_locked, edits);
    edits.mark("locked_item");
}
