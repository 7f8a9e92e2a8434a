#include "ui/slider.h"

#include "base/text.h"
#include "ui/theme.h"

#include <fmt/format.h>
#define IMGUI_DEFINE_MATH_OPERATORS
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cmath>

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

// `id_text` is what the id was made from: the text field takes its own from it.
Turned type_number(const ImRect& box, ImGuiID id, const char* id_text, double& value) {
    Turned turned;
    double typed = value;
    const bool is_edited =
        ImGui::TempInputScalar(box, id, id_text, ImGuiDataType_Double, &typed, "%.7g");
    turned.is_changed = is_edited && std::isfinite(typed);
    if (turned.is_changed)
        value = typed;
    turned.is_finished = ImGui::IsItemDeactivatedAfterEdit();
    return turned;
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
        return type_number(box, id, id_text, value);
    if (wants_typing(box, ImGui::ItemHoverable(box, id))) {
        ImGui::ClearActiveID();
        return type_number(box, id, id_text, value);
    }
    ImGui::ButtonBehavior(box, id, &is_hovered, &is_held);
    Turned turned;
    const ImGuiIO& io = ImGui::GetIO();
    const bool has_moved = io.MouseClicked[0] || io.MouseDelta.x != 0.0f;
    if (is_held && has_moved) {
        const double next = dragged(value, box, facts);
        turned.is_changed = next != value;
        value = next;
        if (turned.is_changed)
            ImGui::MarkItemEdited(id);
    }
    draw_bar(box, value, facts, is_hovered || is_held);
    turned.is_finished = ImGui::IsItemDeactivatedAfterEdit();
    return turned;
}

Turned draw_number(const char* id_text, double& value, float width, bool is_changed) {
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
        return type_number(box, id, id_text, value);

    ImDrawList& list = *window->DrawList;
    if (is_hovered)
        list.AddRectFilled(box.Min, box.Max, theme::packed(theme::field_hovered),
                           ImGui::GetStyle().FrameRounding);
    const std::string text = short_number(value);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 place(std::max(box.Min.x, box.Max.x - size.x - 3.0f),
                       box.Min.y + (box.GetHeight() - size.y) * 0.5f);
    list.PushClipRect(box.Min, box.Max, true);
    list.AddText(place, theme::packed(is_changed ? theme::accent : theme::text), text.c_str());
    list.PopClipRect();
    return {};
}
