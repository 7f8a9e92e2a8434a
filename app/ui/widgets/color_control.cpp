#include "ui/widgets/color_control.h"

#include "model/look/color.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {
using Rgba = std::array<float, 4>;

// Alpha is linear and not converted.
Rgba encoded(const Value& value) {
    Rgba color{0.0f, 0.0f, 0.0f, 1.0f};
    for (std::size_t i = 0; i < std::min<std::size_t>(value.numbers.size(), 4); ++i)
        color[i] = static_cast<float>(i < 3 ? srgb_encode(value.numbers[i]) : value.numbers[i]);
    return color;
}

void decode_into(const Rgba& color, Value& value) {
    for (std::size_t i = 0; i < std::min<std::size_t>(value.numbers.size(), 4); ++i) {
        const auto component = static_cast<double>(color[i]);
        value.numbers[i] = i < 3 ? srgb_decode(component) : component;
    }
}

std::string hex_of(const Rgba& color) {
    const auto byte = [](float component) {
        return static_cast<int>(std::lround(std::clamp(component, 0.0f, 1.0f) * 255.0f));
    };
    return fmt::format("{:02x}{:02x}{:02x}", byte(color[0]), byte(color[1]), byte(color[2]));
}

ValueEdit draw_linear_numbers(Value& value, const Fonts& fonts) {
    ValueEdit edited;
    dim_text("Linear RGB");
    const ScopedFont font(fonts.numbers);
    const float width = ImGui::GetFontSize() * 4.5f;
    for (std::size_t i = 0; i < value.numbers.size(); ++i) {
        ImGui::SameLine();
        edited |=
            draw_number(fmt::format("##{}", i).c_str(), value.numbers[i], width, NumberInfo{});
    }
    return edited;
}

ValueEdit draw_picker(Rgba& color, Value& value, const Fonts& fonts) {
    ValueEdit edited;
    const ImGuiColorEditFlags flags =
        ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoSidePreview |
        ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_DisplayHex |
        ImGuiColorEditFlags_PickerHueBar;
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 16.0f);
    edited.is_changed =
        value.numbers.size() > 3
            ? ImGui::ColorPicker4("##picker", color.data(), flags | ImGuiColorEditFlags_AlphaBar)
            : ImGui::ColorPicker3("##picker", color.data(), flags);
    edited.is_finished = ImGui::IsItemDeactivatedAfterEdit();
    if (edited.is_changed)
        decode_into(color, value);
    edited |= draw_linear_numbers(value, fonts);
    return edited;
}
}  // namespace

ValueEdit draw_color(const Parameter& parameter, Value& value, const FormColumns& columns,
                     const Fonts& fonts) {
    Rgba color = encoded(value);
    const ImVec4 shown(color[0], color[1], color[2], 1.0f);
    if (ImGui::ColorButton("##swatch", shown,
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                           {columns.control, ImGui::GetFrameHeight()}))
        ImGui::OpenPopup("picker");
    ImGui::SameLine(0.0f, ImGui::GetStyle().ItemInnerSpacing.x);
    {
        const ScopedFont font(fonts.numbers);
        const std::string hex = hex_of(color);
        const float left = columns.number - ImGui::CalcTextSize(hex.c_str()).x - 3.0f;
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, left));
        ImGui::AlignTextToFramePadding();
        const ScopedColor text(ImGuiCol_Text,
                               value == parameter.initial ? theme::text : theme::accent);
        ImGui::TextUnformatted(hex.c_str());
    }
    ValueEdit edited;
    if (ImGui::BeginPopup("picker")) {
        edited = draw_picker(color, value, fonts);
        ImGui::EndPopup();
    }
    return edited;
}
