#include "ui/widgets/form.h"

#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>

namespace {
float column_gap() {
    return ImGui::GetStyle().ItemInnerSpacing.x;
}
}  // namespace

float FormColumns::control_and_number() const {
    return control + column_gap() + number;
}

FormColumns form_columns(float longest_label) {
    const float room = ImGui::GetContentRegionAvail().x;
    FormColumns columns;
    columns.button = ImGui::GetFrameHeight();
    const bool is_narrow = room < ImGui::GetFontSize() * 18.0f;
    columns.number = std::round(ImGui::GetFontSize() * (is_narrow ? 3.4f : 4.4f));
    const float rest =
        std::max(60.0f, room - columns.button - columns.number - 3.0f * column_gap());
    constexpr float usual_label = 6.2f;  // em
    const float label = longest_label > 0.0f ? longest_label : usual_label * ImGui::GetFontSize();
    columns.label = std::floor(std::clamp(label, 0.25f * rest, 0.6f * rest));
    columns.control = std::floor(rest - columns.label);
    return columns;
}

FormColumns check_box_columns() {
    FormColumns columns = form_columns(0.0f);
    const float box = ImGui::GetFrameHeight();
    columns.label += columns.control_and_number() - box;
    columns.control = box;
    columns.number = -column_gap();
    return columns;
}

float form_width() {
    return ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() - column_gap();
}

bool form_label(const std::string& label, const FormColumns& columns, bool is_changed) {
    const float height = ImGui::GetFrameHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool is_clicked = ImGui::InvisibleButton(
        "##label", {columns.label, height},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
    const ImVec4 color = is_changed || ImGui::IsItemHovered() ? theme::text : theme::label;
    const std::string cut = elided_to_width(label, columns.label);
    const float top = at.y + (height - ImGui::GetFontSize()) * 0.5f;
    ImGui::GetWindowDrawList()->AddText({at.x, top}, theme::packed(color), cut.c_str());
    return is_clicked;
}

void form_control(const FormColumns& columns) {
    ImGui::SameLine(ImGui::GetWindowContentRegionMin().x + columns.label + column_gap());
}

ValueEdit form_slider(const char* id, double& value, const SliderInfo& info,
                      const FormColumns& columns, const Fonts& fonts) {
    const ScopedId scope{std::string(id)};
    const ScopedFont font(fonts.numbers);
    const ScopedStyle<ImVec2> padding(
        ImGuiStyleVar_FramePadding,
        ImVec2(4.0f,
               ImGui::GetStyle().FramePadding.y + (fonts.text->FontSize - fonts.numbers->FontSize) *
                                                      0.5f * ImGui::GetIO().FontGlobalScale));
    ValueEdit edited = draw_slider("##slider", value, info, columns.control);
    tooltip(info.warning.empty() ? range_text(info) : range_text(info) + "\n" + info.warning);
    ImGui::SameLine(0.0f, column_gap());
    edited |= draw_number("##number", value, columns.number, number_info(info));
    return edited;
}

bool form_reset(const std::string& help, bool is_changed, const FormColumns& columns) {
    ImGui::SameLine(ImGui::GetWindowContentRegionMin().x + columns.label + columns.control +
                    columns.number + 3.0f * column_gap());
    if (is_changed)
        return icon_button("##reset", Icon::reset, help, theme::dim);
    ImGui::Dummy({columns.button, ImGui::GetFrameHeight()});
    return false;
}

bool form_list(const char* id, const char* const* labels, int count, int& chosen, float width,
               const char* otherwise) {
    bool is_changed = false;
    if (!begin_combo(id, chosen >= 0 && chosen < count ? labels[chosen] : otherwise, width))
        return false;
    const int before = chosen;
    for (int i = 0; i < count; ++i) {
        if (ImGui::Selectable(labels[i], i == before) && i != before) {
            chosen = i;
            is_changed = true;
        }
        focus_list_item(labels[i], i == before);
    }
    ImGui::EndCombo();
    return is_changed;
}
