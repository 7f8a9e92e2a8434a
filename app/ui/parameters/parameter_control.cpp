#include "ui/parameters/parameter_control.h"

#include "lab/media/look_media.h"
#include "model/look/color.h"
#include "model/look/decay.h"
#include "model/look/value_text.h"
#include "model/picture/aliasing.h"
#include "model/tuning/slider_range.h"
#include "signals/patterns/generated_picture.h"
#include "ui/parameters/parameter_help.h"
#include "ui/parameters/parameter_marks.h"
#include "ui/widgets/color_control.h"
#include "ui/widgets/form.h"
#include "ui/widgets/point_pad.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace {
SliderInfo info_for(const ParameterEntry& entry, std::size_t component) {
    const Parameter& parameter = entry.parameter;
    SliderInfo info{
        .low = parameter.range.low,
        .high = parameter.range.high,
        .step = step_of(parameter),
        .scale = parameter.scale,
        .is_changed = entry.is_changed,
        .unit = parameter.control == Control::angle ? "°" : std::string(shown_unit(parameter)),
        .limit = parameter.limit,
        .is_whole = parameter.type.scalar != Scalar::floating,
        .is_decay = is_decay(parameter),
        .steps_from = entry.declared.low,
        .wants_focus = entry.typed == component};
    if (component < parameter.initial.numbers.size())
        info.initial = parameter.initial.numbers[component];
    return info;
}

void tell_period(const ParameterEntry& entry, SliderInfo& info) {
    if (!entry.period.period)
        return;
    if (is_period(entry.parameter))
        info.safe = safe_periods(info.low, info.high);
    info.warning = moire_warning(entry);
    if (entry.period.is_too_fine)
        info.note = "below 2 px";
    if (entry.period.beat)
        info.note = fmt::format("moiré {} px", short_number(std::round(*entry.period.beat)));
}

ValueEdit draw_component(const ParameterEntry& entry, std::size_t component, Value& value,
                         const FormColumns& columns, const Fonts& fonts, Edits& edits) {
    SliderInfo info = info_for(entry, component);
    const double factor = shown_factor(entry.parameter);
    info.low *= factor;
    info.high *= factor;
    info.step *= factor;
    info.steps_from = entry.declared.low * factor;
    if (info.initial)
        *info.initial *= factor;
    if (entry.now && component < entry.now->numbers.size())
        info.now = entry.now->numbers[component] * factor;
    if (info.limit)
        info.limit = Limit{info.limit->low * factor, info.limit->high * factor};
    double shown = value.numbers[component] * factor;
    if (is_decay(entry.parameter))
        info.note = fmt::format("½ {}", duration_text(half_life(shown)));
    tell_period(entry, info);
    const std::string id = std::to_string(component);
    const ValueEdit edited = form_slider(id.c_str(), shown, info, columns, fonts);
    if (component == 0)
        edits.mark("number:" + entry.parameter.name);
    if (!info.warning.empty())
        edits.mark("moire:" + entry.parameter.name);
    if (edited.is_changed)
        value.numbers[component] = shown / factor;
    return edited;
}

ValueEdit draw_parts(const ParameterEntry& entry, Value& value, const FormColumns& columns,
                     const Fonts& fonts, Edits& edits) {
    ValueEdit edited;
    const float indent = ImGui::GetFontSize() * 0.95f;  // indent of a heading's text
    FormColumns indented = columns;
    indented.label -= indent;
    for (std::size_t i = 0; i < value.numbers.size(); ++i) {
        const ScopedId id(std::to_string(i));
        ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMin().x + indent);
        form_label(component_label(entry.parameter, i), indented, false);
        form_control(columns);
        edited |= draw_component(entry, i, value, columns, fonts, edits);
    }
    return edited;
}

bool is_check_box(const Parameter& parameter) {
    return parameter.control == Control::slider && parameter.type == NumberType{Scalar::boolean};
}

ValueEdit draw_check_boxes(const Parameter& parameter, Value& value) {
    ValueEdit edited;
    for (std::size_t i = 0; i < value.numbers.size(); ++i) {
        bool is_on = value.numbers[i] != 0.0;
        if (i > 0)
            ImGui::SameLine();
        if (ImGui::Checkbox(("##" + std::to_string(i)).c_str(), &is_on)) {
            value.numbers[i] = is_on ? 1.0 : 0.0;
            edited = {true, true};
        }
        if (value.numbers.size() > 1)
            tooltip(component_label(parameter, i));
    }
    return edited;
}

constexpr float swatch_size = 0.8f;  // in font sizes

// The width of a row in the list: swatch, label and note.
float width_of_row(const Parameter& list) {
    float label = 0.0f;
    float note = 0.0f;
    for (const Item& item : list.items) {
        label = std::max(label, ImGui::CalcTextSize(item.label.c_str()).x);
        note = std::max(note, ImGui::CalcTextSize(item.note.c_str()).x);
    }
    return label + note + 3.0f * ImGui::GetFontSize();
}

void draw_swatch(const std::array<double, 3>& light, const ImVec2& at) {
    const float size = std::round(ImGui::GetFontSize() * swatch_size);
    const float top = at.y + std::round((ImGui::GetTextLineHeight() - size) * 0.5f);
    const ImVec4 color(static_cast<float>(srgb_encode(light[0])),
                       static_cast<float>(srgb_encode(light[1])),
                       static_cast<float>(srgb_encode(light[2])), 1.0f);
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, top}, {at.x + size, top + size},
                                              theme::packed(color));
}

bool draw_row(const Item& item, bool is_chosen, float indent, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool is_clicked =
        ImGui::Selectable(("##" + item.label).c_str(), is_chosen, 0, {width, 0.0f});
    focus_list_item(item.label, is_chosen);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (item.color)
        draw_swatch(*item.color, at);
    list.AddText({at.x + indent, at.y}, theme::packed(theme::text), item.label.c_str());
    const float end = at.x + std::max(width, ImGui::GetItemRectSize().x);
    list.AddText({end - ImGui::CalcTextSize(item.note.c_str()).x, at.y}, theme::packed(theme::dim),
                 item.note.c_str());
    return is_clicked;
}

ValueEdit draw_list(const ParameterEntry& entry, Value& value, const FormColumns& columns,
                    Edits& edits) {
    const std::vector<Item>& items = entry.parameter.items;
    const auto chosen = std::ranges::find(items, value.number(), &Item::value);
    if (!begin_combo("##list", chosen == items.end() ? "" : chosen->label,
                     columns.control_and_number()))
        return {};
    const bool has_swatches =
        std::ranges::any_of(items, [](const Item& item) { return item.color.has_value(); });
    const float indent = has_swatches ? ImGui::GetFontSize() * (swatch_size + 0.6f) : 0.0f;
    const float width = std::max(indent + width_of_row(entry.parameter),
                                 columns.control_and_number() - 2.0f * ImGui::GetFontSize());
    ValueEdit edited;
    for (auto item = items.begin(); item != items.end(); ++item) {
        if (draw_row(*item, item == chosen, indent, width) && item != chosen) {
            value = Value(item->value);
            edited = {true, true};
        }
        edits.mark(fmt::format("item:{}:{}", entry.parameter.name, item->label));
    }
    ImGui::EndCombo();
    return edited;
}

ValueEdit draw_matrix(const ParameterEntry& entry, Value& value, const FormColumns& columns,
                      const Fonts& fonts) {
    const NumberType& type = entry.parameter.type;
    const ScopedFont font(fonts.numbers);
    const float width = columns.control_and_number() / static_cast<float>(type.columns) - 2.0f;
    ValueEdit edited;
    const auto rows = static_cast<std::size_t>(type.rows);
    const auto count = static_cast<std::size_t>(type.columns);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < count; ++column) {
            if (column > 0)
                ImGui::SameLine(0.0f, 2.0f);
            const std::size_t index = column * rows + row;
            edited |= draw_number(fmt::format("##{}", index).c_str(), value.numbers[index], width,
                                  number_info(info_for(entry, index)));
        }
    }
    return edited;
}

ValueEdit draw_trigger(Value& value, const FormColumns& columns) {
    ImGui::Button("Trigger", {columns.control_and_number(), 0.0f});
    const double wanted = ImGui::IsItemActive() ? 1.0 : 0.0;
    if (wanted == value.number())
        return {};
    value = Value(wanted);
    return {true, wanted == 0.0};
}

ValueEdit draw_file(const ParameterEntry& entry, const FormColumns& columns, Edits& edits) {
    const auto made = made_name(entry.value.path);
    const std::string name =
        made ? std::string(*made) : std::filesystem::path(entry.value.path).filename().string();
    const std::string label = (name.empty() ? std::string("Choose…") : name) + "##file";
    if (ImGui::Button(label.c_str(), {columns.control_and_number(), 0.0f}))
        edits.show({.kind = Dialog::Kind::choose_file, .subject = entry.parameter.name});
    return {};
}

ValueEdit draw_control(const ParameterEntry& entry, Value& value, const FormColumns& columns,
                       const Fonts& fonts, Edits& edits) {
    const Parameter& parameter = entry.parameter;
    switch (parameter.control) {
        case Control::list:
            return draw_list(entry, value, columns, edits);
        case Control::color:
            return draw_color(parameter, value, columns, fonts);
        case Control::point:
            return draw_point(parameter, value, entry.now, number_info(info_for(entry, 0)), columns,
                              fonts);
        case Control::event:
            return draw_trigger(value, columns);
        case Control::image:
        case Control::sound:
            return draw_file(entry, columns, edits);
        case Control::slider:
        case Control::angle:
            break;
    }
    if (parameter.type.columns > 1)
        return draw_matrix(entry, value, columns, fonts);
    if (parameter.type.scalar == Scalar::boolean)
        return draw_check_boxes(parameter, value);
    return draw_component(entry, 0, value, columns, fonts, edits);
}

void draw_reset(const ParameterEntry& entry, const FormColumns& columns, Edits& edits) {
    const Parameter& parameter = entry.parameter;
    if (form_reset(fmt::format("Reset to {}", short_value(parameter, parameter.initial)),
                   entry.is_changed, columns))
        reset_parameter(parameter.name, edits);
    if (entry.is_changed)
        edits.mark("reset:" + parameter.name);
}
}  // namespace

int expected_lines(const Parameter& parameter) {
    constexpr int lines_of_pad = 5;
    if (parameter.control == Control::point)
        return lines_of_pad;
    if (has_parts(parameter))
        return 1 + parameter.type.rows;
    return parameter.type.columns > 1 ? parameter.type.rows : 1;
}

namespace {
// Dims the rows drawn since `top`. Labels keep a contrast of 3:1.
void dim_rows_since(float top) {
    theme::Color veil = theme::pane;
    veil.alpha = theme::dimming;
    const float left = ImGui::GetWindowPos().x;
    ImGui::GetWindowDrawList()->AddRectFilled(
        {left, top}, {left + ImGui::GetWindowWidth(), ImGui::GetCursorScreenPos().y},
        theme::packed(veil));
}

// Stores which of the rows drawn since `top` is under the pointer. The components of a vector are
// below its label.
void tell_pointed(const ParameterEntry& entry, float top, Edits& edits) {
    const float bottom = ImGui::GetCursorScreenPos().y - ImGui::GetStyle().ItemSpacing.y;
    const float left = ImGui::GetWindowPos().x;
    if (!ImGui::IsWindowHovered() ||
        !ImGui::IsMouseHoveringRect({left, top}, {left + ImGui::GetWindowWidth(), bottom}))
        return;
    std::size_t component = 0;
    if (has_parts(entry.parameter)) {
        const float row = ImGui::GetFrameHeightWithSpacing();
        const float part = (ImGui::GetMousePos().y - top) / row - 1.0f;
        component = static_cast<std::size_t>(std::max(part, 0.0f));
    }
    edits.arrange([pointed = Pointed{entry.parameter.name, component}](WindowState& window) {
        window.parameters.pointed = pointed;
    });
}
}  // namespace

bool draw_parameter(const ParameterEntry& entry, const Scene& scene, Edits& edits) {
    const Parameter& parameter = entry.parameter;
    const ScopedId scope(parameter.name);
    const float top = ImGui::GetCursorScreenPos().y;
    const FormColumns columns =
        is_check_box(parameter) ? check_box_columns() : form_columns(entry.longest_label);
    const ParameterMarks marks = parameter_marks(entry.setting, columns);
    if (form_label(parameter.label, marks.reduced(columns), entry.is_changed))
        ImGui::OpenPopup("about");
    edits.mark("label:" + parameter.name);
    draw_parameter_help(entry, scene, edits);
    draw_parameter_marks(entry, marks, edits);
    Value value = entry.value;
    const bool is_vector = has_parts(parameter);
    if (is_vector)
        draw_reset(entry, columns, edits);
    else
        form_control(columns);
    ImGui::BeginGroup();
    const ValueEdit edited = is_vector ? draw_parts(entry, value, columns, scene.fonts, edits)
                                       : draw_control(entry, value, columns, scene.fonts, edits);
    ImGui::EndGroup();
    const bool is_held = ImGui::IsItemActive();
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right))
        ImGui::OpenPopup("about");
    edits.mark("parameter:" + parameter.name);
    if (edited.is_changed)
        edits.set(parameter.name, value);
    if (edited.is_finished)
        edits.finish();
    if (!is_vector)
        draw_reset(entry, columns, edits);
    if (!entry.without_effect.empty()) {
        dim_rows_since(top);
        edits.mark("dimmed:" + parameter.name);
    }
    tell_pointed(entry, top, edits);
    return is_held;
}
