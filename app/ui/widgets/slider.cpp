#include "ui/widgets/slider.h"

#include "gpu/input_event.h"
#include "model/tuning/slider_range.h"
#include "ui/widgets/theme.h"

#include <fmt/format.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace {
Range range_of(const SliderInfo& info) {
    return {info.low, info.high, info.step};
}

std::optional<Steps> steps_of(const SliderInfo& info) {
    return steps_in(range_of(info), info.steps_from.value_or(info.low));
}

// Slider movement relative to pointer movement.
double factor_of(DragPace pace) {
    return pace == DragPace::fine ? 0.1 : pace == DragPace::coarse ? 10.0 : 1.0;
}
}  // namespace

double slider_ratio(double value, const SliderInfo& info) {
    return ratio_in(range_of(info), info.scale, value);
}

double slider_value(double ratio, const SliderInfo& info) {
    return value_at(range_of(info), info.scale, ratio);
}

double dragged_share(double ratio, double moved, DragPace pace) {
    return std::clamp(ratio + moved * factor_of(pace), 0.0, 1.0);
}

double dragged_value(double ratio, const SliderInfo& info, DragPace pace) {
    const double value = slider_value(ratio, info);
    if (const auto steps = steps_of(info))
        return steps->nearest(value);
    return readable(range_of(info), info.scale, value, factor_of(pace));
}

std::vector<double> notch_ratios(const SliderInfo& info, double width) {
    constexpr double room = 5.0;  // minimum spacing in pixels
    const auto steps = steps_of(info);
    if (!steps || steps->count * room > width + room)
        return {};
    std::vector<double> ratios;
    double last = 0.0;
    for (double i = 0.0; i < steps->count; i += 1.0) {
        const double ratio = slider_ratio(steps->value(i), info);
        if (i > 0.0 && (ratio - last) * width < room)
            return {};
        last = ratio;
        constexpr double end = 1e-6;
        if (ratio > end && ratio < 1.0 - end)
            ratios.push_back(ratio);
    }
    return ratios;
}

std::vector<double> safe_ratios(const SliderInfo& info, double width) {
    constexpr double room = 5.0;  // minimum spacing in pixels
    std::vector<double> ratios;
    for (const double value : info.safe) {
        const double ratio = slider_ratio(value, info);
        if (ratios.empty() || (ratio - ratios.back()) * width >= room)
            ratios.push_back(ratio);
    }
    return ratios;
}

std::string short_number(double value) {
    const double size = std::abs(value);
    if (size != 0.0 && (size >= 1e7 || size < 1e-4))
        return fmt::format("{:.3g}", value);
    const int decimals = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : size >= 1 ? 3 : 4;
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.find('.') != std::string::npos)
        text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
        text.pop_back();
    return text == "-0" ? "0" : text;
}

namespace {
bool wants_typing(const ImRect& box, bool is_hovered) {
    const ImGuiIO& io = ImGui::GetIO();
    return is_hovered && box.Contains(io.MousePos) &&
           ((io.MouseClicked[0] && io.KeyCtrl && !io.KeyShift) || io.MouseDoubleClicked[0]);
}

// Parses the text of a field when it loses the focus.
ValueEdit read_field(const TypedField& field, double& value, const NumberInfo& info) {
    if (field.text == field.before)
        return {};
    TypedNumber typed = read_typed_number(field.text, info);
    typing().complaint = std::move(typed.complaint);
    if (!typed.value || *typed.value == value)
        return {};
    value = *typed.value;
    return {true, true};
}

// `id_text`: the text that `id` was made from. The text field gets the same id.
ValueEdit type_number(const ImRect& box, ImGuiID id, const char* id_text, double& value,
                      const NumberInfo& info) {
    Typing& all = typing();
    std::array<char, 64> text{};
    const std::string current = fmt::format("{:.7g}", value);
    current.copy(text.data(), text.size() - 1);
    if (all.open.id != id) {
        all.left = std::move(all.open);
        all.open = {id, 0, current, current};
    }
    const bool is_cancelled = ImGui::IsKeyPressed(gpu::key::escape, false);
    ImGui::TempInputText(box, id, id_text, text.data(), static_cast<int>(text.size()),
                         ImGuiInputTextFlags_AutoSelectAll);
    all.open.frame = ImGui::GetFrameCount();
    all.open.text = is_cancelled ? all.open.before : text.data();
    if (ImGui::TempInputIsActive(id))
        return {};
    return read_field(std::exchange(all.open, {}), value, info);
}

// Parses a field that lost the focus to another widget in this frame or the last one.
ValueEdit read_if_left(ImGuiID id, double& value, const NumberInfo& info) {
    Typing& all = typing();
    if (all.open.id == id)
        all.left = std::exchange(all.open, {});
    if (all.left.id != id)
        return {};
    const TypedField field = std::exchange(all.left, {});
    return field.frame >= ImGui::GetFrameCount() - 1 ? read_field(field, value, info) : ValueEdit{};
}

// Safe values are marked at the top, steps at the bottom.
void draw_marks(const ImRect& box, const SliderInfo& info) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const double width = box.GetWidth();
    const auto column = [&](double ratio) {
        return std::round(box.Min.x + static_cast<float>(width * ratio)) + 0.5f;
    };
    const float length = box.GetHeight() * 0.16f;
    for (const double ratio : notch_ratios(info, width))
        list.AddLine({column(ratio), box.Max.y - length}, {column(ratio), box.Max.y},
                     theme::packed(theme::faint));
    const theme::Color& safe = info.warning.empty() ? theme::faint : theme::warning;
    for (const double ratio : safe_ratios(info, width))
        list.AddLine({column(ratio), box.Min.y}, {column(ratio), box.Min.y + length},
                     theme::packed(safe));
}

// Left of the grab if it fits there, otherwise right of it.
void draw_note(const ImRect& box, const std::string& note, float pointer, bool is_warning) {
    const ImVec2 size = ImGui::CalcTextSize(note.c_str());
    constexpr float gap = 4.0f;
    const bool is_left = box.Min.x + size.x + 2.0f * gap <= pointer;
    const float left = (is_left ? box.Min.x : std::max(pointer, box.Min.x)) + gap;
    if (note.empty() || left + size.x + gap > box.Max.x)
        return;
    ImGui::GetWindowDrawList()->AddText({left, box.Min.y + (box.GetHeight() - size.y) * 0.5f},
                                        theme::packed(is_warning ? theme::warning : theme::label),
                                        note.c_str());
}

void draw_bar(const ImRect& box, double value, const SliderInfo& info, bool is_hot) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = ImGui::GetStyle().FrameRounding;
    const float width = box.GetWidth();
    const auto at = [&](double number) {
        return box.Min.x + width * static_cast<float>(slider_ratio(number, info));
    };
    list.AddRectFilled(box.Min, box.Max,
                       theme::packed(is_hot ? theme::field_hovered : theme::field), rounding);
    const float origin = info.low < 0.0 && info.high > 0.0 ? at(0.0) : box.Min.x;
    const float ratio = at(value);
    const theme::Color fill = info.is_changed ? theme::accent_filled : theme::filled;
    list.AddRectFilled({std::min(origin, ratio), box.Min.y}, {std::max(origin, ratio), box.Max.y},
                       theme::packed(fill), rounding);
    list.AddRect(box.Min, box.Max, theme::packed(theme::outline), rounding);
    draw_marks(box, info);
    draw_note(box, info.note, ratio, !info.warning.empty());
    if (info.initial && info.is_changed) {
        const float tick = std::clamp(at(*info.initial), box.Min.x + 1.0f, box.Max.x - 1.0f);
        list.AddLine({tick, box.Max.y - box.GetHeight() * 0.3f}, {tick, box.Max.y},
                     theme::packed(theme::dim));
    }
    const float half = std::max(1.0f, box.GetHeight() * 0.06f);
    const float grab = std::clamp(ratio, box.Min.x + half, box.Max.x - half);
    const theme::Color color = info.is_changed || is_hot ? theme::accent : theme::dim;
    list.AddRectFilled({grab - half, box.Min.y}, {grab + half, box.Max.y}, theme::packed(color),
                       half);
}

// Marks the modulated value by a bright line with arrowheads, distinct from the grab.
void draw_now(const ImRect& box, const SliderInfo& info) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float x = box.Min.x + box.GetWidth() * static_cast<float>(slider_ratio(*info.now, info));
    const float head = box.GetHeight() * 0.2f;
    const ImU32 color = theme::packed(theme::text);
    list.AddLine({x, box.Min.y}, {x, box.Max.y}, color);
    list.AddTriangleFilled({x - head, box.Min.y}, {x + head, box.Min.y}, {x, box.Min.y + head},
                           color);
    list.AddTriangleFilled({x - head, box.Max.y}, {x, box.Max.y - head}, {x + head, box.Max.y},
                           color);
}

DragPace drag_pace() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyAlt || (io.KeyCtrl && io.KeyShift))
        return DragPace::coarse;
    return io.KeyShift ? DragPace::fine : DragPace::direct;
}

// The value for the current drag. The unrounded position accumulates, so that fine dragging reaches
// the next step.
double dragged(double value, const ImRect& box, ImGuiID id, const SliderInfo& info) {
    const ImGuiIO& io = ImGui::GetIO();
    const DragPace pace = drag_pace();
    const double width = box.GetWidth();
    SliderDrag& drag = typing().drag;
    const bool is_new = io.MouseClicked[0] || drag.id != id;
    if (is_new)
        drag = {id, slider_ratio(value, info)};
    if (pace == DragPace::direct)
        drag.ratio = (io.MousePos.x - box.Min.x) / width;
    else if (is_new || io.MouseDelta.x == 0.0f)
        return value;
    else
        drag.ratio = dragged_share(drag.ratio, io.MouseDelta.x / width, pace);
    return dragged_value(drag.ratio, info, pace);
}

// Whether the control has the keyboard focus and Enter was pressed. It then becomes a text field.
bool is_entered(ImGuiID id) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    if (context.NavActivateId != id && context.NavActivateInputId != id)
        return false;
    context.NavActivateInputId = id;
    return true;
}

// The value after Left or Right, if the slider has the keyboard focus: a step, or 1/100 of the
// slider. Shift is ten times finer.
double stepped(double value, ImGuiID id, const SliderInfo& info) {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    if (context.NavId != id || context.NavDisableHighlight ||
        (context.IO.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) == 0)
        return value;
    const double sign = ImGui::IsKeyPressed(gpu::key::right)  ? 1.0
                        : ImGui::IsKeyPressed(gpu::key::left) ? -1.0
                                                              : 0.0;
    if (sign == 0.0)
        return value;
    ImGui::NavMoveRequestCancel();  // the focus stays
    if (const auto steps = steps_of(info))
        return std::clamp(steps->nearest(value) + sign * steps->step, info.low, info.high);
    constexpr double share = 0.01;
    const DragPace pace = context.IO.KeyShift ? DragPace::fine : DragPace::direct;
    return dragged_value(dragged_share(slider_ratio(value, info), sign * share, pace), info, pace);
}
}  // namespace

ValueEdit draw_slider(const char* id_text, double& value, const SliderInfo& info, float width) {
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    const ImGuiID id = window->GetID(id_text);
    const ImRect box(window->DC.CursorPos,
                     window->DC.CursorPos + ImVec2(width, ImGui::GetFrameHeight()));
    ImGui::ItemSize(box, ImGui::GetStyle().FramePadding.y);
    if (!ImGui::ItemAdd(box, id, &box))
        return {};
    bool is_hovered = false;
    bool is_held = false;
    if (ImGui::TempInputIsActive(id))
        return type_number(box, id, id_text, value, number_info(info));
    if (is_entered(id) || wants_typing(box, ImGui::ItemHoverable(box, id))) {
        ImGui::ClearActiveID();
        return type_number(box, id, id_text, value, number_info(info));
    }
    ValueEdit edited = read_if_left(id, value, number_info(info));
    ImGui::ButtonBehavior(box, id, &is_hovered, &is_held);
    const ImGuiIO& io = ImGui::GetIO();
    const bool has_moved = io.MouseClicked[0] || io.MouseDelta.x != 0.0f;
    if (is_held && has_moved) {
        const double next = dragged(value, box, id, info);
        edited.is_changed |= next != value;
        value = next;
        if (edited.is_changed)
            ImGui::MarkItemEdited(id);
    }
    if (const double next = stepped(value, id, info); next != value) {
        value = next;
        edited = {true, true};
    }
    draw_bar(box, value, info, is_hovered || is_held);
    if (info.now)
        draw_now(box, info);
    edited.is_finished |= ImGui::IsItemDeactivatedAfterEdit();
    return edited;
}

std::string range_text(const SliderInfo& info) {
    const auto text_of = [&unit = info.unit](double low, double high) {
        return unit.empty()
                   ? fmt::format("{} to {}", short_number(low), short_number(high))
                   : fmt::format("{} to {} {}", short_number(low), short_number(high), unit);
    };
    const auto& limit = info.limit;
    constexpr double practically_none = 1e6;
    if (limit && limit->high - limit->low < practically_none &&
        (limit->low < info.low || limit->high > info.high))
        return fmt::format("{} (typed: {} to {})", text_of(info.low, info.high),
                           short_number(limit->low), short_number(limit->high));
    return text_of(info.low, info.high);
}

namespace {
void draw_number_text(const ImRect& box, double value, const NumberInfo& info) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string text = short_number(value);
    const std::string unit = info.unit.empty() ? std::string() : " " + info.unit;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float unit_width = ImGui::CalcTextSize(unit.c_str()).x;
    const float end = box.Max.x - 3.0f;
    const float top = box.Min.y + (box.GetHeight() - size.y) * 0.5f;
    const bool has_room = end - unit_width - size.x >= box.Min.x;
    const float start = std::max(box.Min.x, end - size.x - (has_room ? unit_width : 0.0f));
    list.PushClipRect(box.Min, box.Max, true);
    list.AddText({start, top}, theme::packed(info.is_changed ? theme::accent : theme::text),
                 text.c_str());
    if (has_room)
        list.AddText({end - unit_width, top}, theme::packed(theme::dim), unit.c_str());
    list.PopClipRect();
}
}  // namespace

ValueEdit draw_number(const char* id_text, double& value, float width, const NumberInfo& info) {
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    const ImGuiID id = window->GetID(id_text);
    const ImRect box(window->DC.CursorPos,
                     window->DC.CursorPos + ImVec2(width, ImGui::GetFrameHeight()));
    ImGui::ItemSize(box, ImGui::GetStyle().FramePadding.y);
    if (!ImGui::ItemAdd(box, id, &box, ImGuiItemFlags_Inputable))
        return {};
    const bool is_hovered = ImGui::ItemHoverable(box, id);
    if (is_hovered)
        ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    const bool is_tabbed_to = (ImGui::GetCurrentContext()->LastItemData.StatusFlags &
                               ImGuiItemStatusFlags_FocusedByTabbing) != 0;
    if (info.wants_focus)
        ImGui::GetCurrentContext()->NavActivateInputId = id;
    if (ImGui::TempInputIsActive(id) || is_tabbed_to || is_entered(id) || info.wants_focus ||
        (is_hovered && ImGui::IsMouseClicked(0)))
        return type_number(box, id, id_text, value, info);
    const ValueEdit edited = read_if_left(id, value, info);
    if (is_hovered)
        window->DrawList->AddRectFilled(box.Min, box.Max, theme::packed(theme::field_hovered),
                                        ImGui::GetStyle().FrameRounding);
    draw_number_text(box, value, info);
    return edited;
}
