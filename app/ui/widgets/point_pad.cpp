#include "ui/widgets/point_pad.h"

#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"

#include <algorithm>
#include <cmath>

namespace {
double ratio_of(double value, const Range& range) {
    const double span = range.high - range.low;
    return span > 0.0 ? std::clamp((value - range.low) / span, 0.0, 1.0) : 0.0;
}

double value_at(double ratio, const Range& range) {
    const double span = range.high - range.low;
    const double step = span > 0.0 ? std::pow(10.0, std::floor(std::log10(span / 500.0))) : 1.0;
    return std::round((range.low + std::clamp(ratio, 0.0, 1.0) * span) / step) * step;
}

/// The screen position of a point in the pad.
ImVec2 point_in(const Parameter& parameter, double x, double y, const ImVec2& low,
                const ImVec2& high) {
    return {low.x + (high.x - low.x) * static_cast<float>(ratio_of(x, range_of(parameter, 0))),
            high.y - (high.y - low.y) * static_cast<float>(ratio_of(y, range_of(parameter, 1)))};
}

void draw_cross(const ImVec2& low, const ImVec2& high, const ImVec2& at, bool is_changed) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, theme::packed(theme::field), ImGui::GetStyle().FrameRounding);
    list.AddRect(low, high, theme::packed(theme::outline), ImGui::GetStyle().FrameRounding);
    const ImVec2 middle((low.x + high.x) * 0.5f, (low.y + high.y) * 0.5f);
    const ImU32 faint = theme::packed(theme::line);
    list.AddLine({middle.x, low.y}, {middle.x, high.y}, faint);
    list.AddLine({low.x, middle.y}, {high.x, middle.y}, faint);
    const ImU32 color = theme::packed(is_changed ? theme::accent : theme::text);
    list.AddCircleFilled(at, ImGui::GetFontSize() * 0.25f, color);
}

void draw_ring(const ImVec2& at) {
    ImGui::GetWindowDrawList()->AddCircle(at, ImGui::GetFontSize() * 0.35f,
                                          theme::packed(theme::text), 0, 1.5f);
}

ValueEdit draw_pad(const Parameter& parameter, double& x, double& y, bool is_changed, float width) {
    const float height = std::round(ImGui::GetFontSize() * 6.0f);
    ImGui::InvisibleButton("##pad", {width, height});
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ValueEdit edited;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    const bool has_moved = ImGui::IsItemActivated() || moved.x != 0.0f || moved.y != 0.0f;
    if (ImGui::IsItemActive() && has_moved) {
        x = value_at((mouse.x - low.x) / width, range_of(parameter, 0));
        y = value_at((high.y - mouse.y) / height, range_of(parameter, 1));
        edited.is_changed = true;
    }
    edited.is_finished = ImGui::IsItemDeactivated();
    draw_cross(low, high, point_in(parameter, x, y, low, high), is_changed);
    return edited;
}
}  // namespace

ValueEdit draw_point(const Parameter& parameter, Value& value, const Value* now,
                     const NumberInfo& info, const FormColumns& columns, const Fonts& fonts) {
    if (value.numbers.size() < 2)
        return {};
    const float width = columns.control_and_number();
    ValueEdit edited =
        draw_pad(parameter, value.numbers[0], value.numbers[1], info.is_changed, width);
    if (now && now->numbers.size() >= 2)
        draw_ring(point_in(parameter, now->numbers[0], now->numbers[1], ImGui::GetItemRectMin(),
                           ImGui::GetItemRectMax()));
    const ScopedFont font(fonts.numbers);
    const float half = (width - 4.0f) * 0.5f;
    for (std::size_t i = 0; i < value.numbers.size(); ++i) {
        if (i > 0)
            ImGui::SameLine(0.0f, 4.0f);
        NumberInfo own = info;
        own.wants_focus = info.wants_focus && i == 0;
        edited |= draw_number(i == 0 ? "##x" : i == 1 ? "##y" : "##z", value.numbers[i], half, own);
    }
    return edited;
}
