#include "ui/slider.h"

#include "gpu/input_event.h"
#include "ui/theme.h"

#include <fmt/format.h>
#define IMGUI_DEFINE_MATH_OPERATORS
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

double slider_place(double value, const SliderFacts& facts) {
    const double span = facts.high - facts.low;
    if (!(span > 0.0))
        return 0.0;
    const double inside = std::clamp(value, facts.low, facts.high);
    if (!facts.is_logarithmic)
        return (inside - facts.low) / span;
    if (facts.low > 0.0)
        return std::log(inside / facts.low) / std::log(facts.high / facts.low);
    return std::cbrt((inside - facts.low) / span);
}

double slider_value(double place, const SliderFacts& facts) {
    const double t = std::clamp(place, 0.0, 1.0);
    const double span = facts.high - facts.low;
    if (!facts.is_logarithmic)
        return facts.low + t * span;
    if (facts.low > 0.0)
        return facts.low * std::pow(facts.high / facts.low, t);
    return facts.low + span * t * t * t;
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
// A drag stops at numbers that read well: about a thousand of them over the slider.
double rounded(double value, const SliderFacts& facts, bool is_fine) {
    double step = facts.step;
    if (step <= 0.0) {
        const double size = facts.is_logarithmic ? std::abs(value) : facts.high - facts.low;
        if (!(size > 0.0))
            return value;
        step = std::pow(10.0, std::floor(std::log10(size / 500.0))) * (is_fine ? 0.1 : 1.0);
    }
    const double near = std::round(value / step) * step;
    return std::clamp(near, facts.low, facts.high);
}

bool wants_typing(const ImRect& box, bool is_hovered) {
    const ImGuiIO& io = ImGui::GetIO();
    return is_hovered && box.Contains(io.MousePos) &&
           ((io.MouseClicked[0] && io.KeyCtrl) || io.MouseDoubleClicked[0]);
}

Typing& typing() {
    return *static_cast<Typing*>(ImGui::GetIO().UserData);
}

// The field has been left, by whatever way: reads what is in it.
Turned read_field(const TypedField& field, double& value, const NumberFacts& facts) {
    if (field.text == field.before)
        return {};
    TypedNumber typed = read_typed_number(field.text, facts);
    typing().complaint = std::move(typed.complaint);
    if (!typed.value || *typed.value == value)
        return {};
    value = *typed.value;
    return {true, true};
}

// `id_text` is what the id was made from: the text field takes its own from it.
Turned type_number(const ImRect& box, ImGuiID id, const char* id_text, double& value,
                   const NumberFacts& facts) {
    Typing& all = typing();
    std::array<char, 64> text{};
    const std::string present = fmt::format("{:.7g}", value);
    present.copy(text.data(), text.size() - 1);
    if (all.open.id != id) {
        all.left = std::move(all.open);
        all.open = {id, 0, present, present};
    }
    const bool is_cancelled = ImGui::IsKeyPressed(gpu::key::escape, false);
    ImGui::TempInputText(box, id, id_text, text.data(), static_cast<int>(text.size()),
                         ImGuiInputTextFlags_AutoSelectAll);
    all.open.frame = ImGui::GetFrameCount();
    all.open.text = is_cancelled ? all.open.before : text.data();
    if (ImGui::TempInputIsActive(id))
        return {};
    return read_field(std::exchange(all.open, {}), value, facts);
}

// Reads a field that another widget took the keyboard from, in this frame or since the last.
Turned read_if_left(ImGuiID id, double& value, const NumberFacts& facts) {
    Typing& all = typing();
    if (all.open.id == id)
        all.left = std::exchange(all.open, {});
    if (all.left.id != id)
        return {};
    const TypedField field = std::exchange(all.left, {});
    return field.frame >= ImGui::GetFrameCount() - 1 ? read_field(field, value, facts) : Turned{};
}

void draw_bar(const ImRect& box, double value, const SliderFacts& facts, bool is_hot) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float rounding = ImGui::GetStyle().FrameRounding;
    const float width = box.GetWidth();
    const auto at = [&](double number) {
        return box.Min.x + width * static_cast<float>(slider_place(number, facts));
    };
    list.AddRectFilled(box.Min, box.Max,
                       theme::packed(is_hot ? theme::field_hovered : theme::field), rounding);
    const float origin = facts.low < 0.0 && facts.high > 0.0 ? at(0.0) : box.Min.x;
    const float place = at(value);
    const theme::Color fill = facts.is_changed ? theme::accent_filled : theme::filled;
    list.AddRectFilled({std::min(origin, place), box.Min.y}, {std::max(origin, place), box.Max.y},
                       theme::packed(fill), rounding);
    if (facts.initial && facts.is_changed) {
        const float tick = std::clamp(at(*facts.initial), box.Min.x + 1.0f, box.Max.x - 1.0f);
        list.AddLine({tick, box.Max.y - box.GetHeight() * 0.3f}, {tick, box.Max.y},
                     theme::packed(theme::dim));
    }
    const float half = std::max(1.0f, box.GetHeight() * 0.06f);
    const float grab = std::clamp(place, box.Min.x + half, box.Max.x - half);
    const theme::Color color = facts.is_changed || is_hot ? theme::accent : theme::dim;
    list.AddRectFilled({grab - half, box.Min.y}, {grab + half, box.Max.y}, theme::packed(color),
                       half);
}

// The value that the mouse asks for.
double dragged(double value, const ImRect& box, const SliderFacts& facts) {
    const ImGuiIO& io = ImGui::GetIO();
    const double width = box.GetWidth();
    if (io.KeyShift) {
        const double place = slider_place(value, facts) + 0.1 * io.MouseDelta.x / width;
        return io.MouseDelta.x == 0.0f ? value : rounded(slider_value(place, facts), facts, true);
    }
    return rounded(slider_value((io.MousePos.x - box.Min.x) / width, facts), facts, false);
}
}  // namespace

Turned draw_slider(const char* id_text, double& value, const SliderFacts& facts, float width) {
    ImGuiWindow* window = ImGui::GetCurrentWindow();
    const ImGuiID id = window->GetID(id_text);
    const ImRect box(window->DC.CursorPos,
                     window->DC.CursorPos + ImVec2(width, ImGui::GetFrameHeight()));
    ImGui::ItemSize(box, ImGui::GetStyle().FramePadding.y);
    if (!ImGui::ItemAdd(box, id, &box, ImGuiItemFlags_Inputable))
        return {};
    bool is_hovered = false;
    bool is_held = false;
    if (ImGui::TempInputIsActive(id))
        return type_number(box, id, id_text, value, facts.number());
    if (wants_typing(box, ImGui::ItemHoverable(box, id))) {
        ImGui::ClearActiveID();
        return type_number(box, id, id_text, value, facts.number());
    }
    Turned turned = read_if_left(id, value, facts.number());
    ImGui::ButtonBehavior(box, id, &is_hovered, &is_held);
    const ImGuiIO& io = ImGui::GetIO();
    const bool has_moved = io.MouseClicked[0] || io.MouseDelta.x != 0.0f;
    if (is_held && has_moved) {
        const double next = dragged(value, box, facts);
        turned.is_changed |= next != value;
        value = next;
        if (turned.is_changed)
            ImGui::MarkItemEdited(id);
    }
    draw_bar(box, value, facts, is_hovered || is_held);
    turned.is_finished |= ImGui::IsItemDeactivatedAfterEdit();
    return turned;
}

bool is_short(const std::string& unit) {
    constexpr std::ptrdiff_t most_letters = 4;
    return std::count_if(unit.begin(), unit.end(), [](char c) {
               return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
           }) <= most_letters;
}

std::string range_text(const SliderFacts& facts) {
    const std::string unit = facts.unit.empty() ? "" : " " + facts.unit;
    std::string text =
        fmt::format("{} to {}{}", short_number(facts.low), short_number(facts.high), unit);
    const auto& limit = facts.limit;
    constexpr double practically_none = 1e6;
    if (limit && limit->high - limit->low < practically_none &&
        (limit->low < facts.low || limit->high > facts.high))
        text += fmt::format("; typed: {} to {}{}", short_number(limit->low),
                            short_number(limit->high), unit);
    return text;
}

namespace {
void draw_number_text(const ImRect& box, double value, const NumberFacts& facts) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string text = short_number(value);
    const std::string unit =
        facts.unit.empty() || !is_short(facts.unit) ? std::string() : " " + facts.unit;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float unit_width = ImGui::CalcTextSize(unit.c_str()).x;
    const float end = box.Max.x - 3.0f;
    const float top = box.Min.y + (box.GetHeight() - size.y) * 0.5f;
    const bool has_room = end - unit_width - size.x >= box.Min.x;
    const float start = std::max(box.Min.x, end - size.x - (has_room ? unit_width : 0.0f));
    list.PushClipRect(box.Min, box.Max, true);
    list.AddText({start, top}, theme::packed(facts.is_changed ? theme::accent : theme::text),
                 text.c_str());
    if (has_room)
        list.AddText({end - unit_width, top}, theme::packed(theme::dim), unit.c_str());
    list.PopClipRect();
}
}  // namespace

Turned draw_number(const char* id_text, double& value, float width, const NumberFacts& facts) {
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
    if (ImGui::TempInputIsActive(id) || is_tabbed_to || (is_hovered && ImGui::IsMouseClicked(0)))
        return type_number(box, id, id_text, value, facts);
    const Turned turned = read_if_left(id, value, facts);
    if (is_hovered)
        window->DrawList->AddRectFilled(box.Min, box.Max, theme::packed(theme::field_hovered),
                                        ImGui::GetStyle().FrameRounding);
    draw_number_text(box, value, facts);
    return turned;
}
