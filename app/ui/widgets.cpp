#include "ui/widgets.h"

#include "ui/scoped.h"
#include "ui/theme.h"

#include <fmt/format.h>

#include <algorithm>

ImTextureID texture_id(std::uintptr_t handle) {
    return reinterpret_cast<ImTextureID>(handle);
}

Pane::Pane(const char* id, const Rect& place, const ImVec4& background, bool is_padded) {
    ImGui::SetCursorPos({place.left, place.top});
    const ScopedColor color(ImGuiCol_ChildBg, background);
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding,
                                      is_padded ? ImGui::GetStyle().WindowPadding : ImVec2(0, 0));
    const ImGuiWindowFlags flags =
        is_padded ? ImGuiWindowFlags_AlwaysUseWindowPadding
                  : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    ImGui::BeginChild(id, {std::max(place.width, 1.0f), std::max(place.height, 1.0f)}, false,
                      flags);
}

Pane::~Pane() {
    ImGui::EndChild();
}

void dim_text(const std::string& text) {
    const ScopedColor color(ImGuiCol_Text, theme::dim);
    ImGui::TextUnformatted(text.c_str());
}

std::string cut_to_fit(const std::string& text, float width) {
    const auto width_of = [](const std::string& part) {
        return ImGui::CalcTextSize(part.c_str()).x;
    };
    if (width_of(text) <= width)
        return text;
    std::string cut = text;
    while (!cut.empty() && width_of(cut + "…") > width) {
        while (cut.size() > 1 && (static_cast<unsigned char>(cut.back()) & 0xC0) == 0x80)
            cut.pop_back();  // the tail of one character
        cut.pop_back();
    }
    return cut + "…";
}

void fitted_text(const std::string& text, float width, const ImVec4& color) {
    const std::string cut = cut_to_fit(text, width);
    {
        const ScopedColor scoped(ImGuiCol_Text, color);
        ImGui::TextUnformatted(cut.c_str());
    }
    if (cut != text)
        tooltip(text);
}

void tooltip(const std::string& text) {
    if (text.empty() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) ||
        ImGui::GetIO().MouseDown[0])
        return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void heading(const std::string& text) {
    const ScopedColor color(ImGuiCol_Text, theme::dim);
    ImGui::TextUnformatted(text.c_str());
    ImGui::Dummy({0.0f, 1.0f});
}

bool section(const std::string& label, bool opens_first, bool is_changed) {
    const ScopedColor text(ImGuiCol_Text, is_changed ? theme::accent : theme::text);
    const ScopedColor back(ImGuiCol_Header, theme::none);
    const ImGuiTreeNodeFlags flags =
        ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen |
        ImGuiTreeNodeFlags_FramePadding | ImGuiTreeNodeFlags_AllowItemOverlap |
        (opens_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    return ImGui::TreeNodeEx(label.c_str(), flags);
}

bool quiet_button(const std::string& label) {
    const ScopedColor back(ImGuiCol_Button, theme::none);
    return ImGui::Button(label.c_str());
}

int choice(const char* id, const char* const* labels, int count, int chosen, Edits& edits) {
    const ScopedId scope{std::string(id)};
    const ScopedStyle<ImVec2> gap(ImGuiStyleVar_ItemSpacing,
                                  ImVec2(2.0f, ImGui::GetStyle().ItemSpacing.y));
    for (int i = 0; i < count; ++i) {
        if (i > 0)
            ImGui::SameLine();
        const bool is_chosen = i == chosen;
        const ScopedColor text(ImGuiCol_Text, is_chosen ? theme::accent : theme::dim);
        const ScopedColor back(ImGuiCol_Button, is_chosen ? theme::field : theme::none);
        if (ImGui::Button(labels[i]))
            chosen = i;
        edits.mark(std::string(id) + ':' + labels[i]);
    }
    return chosen;
}

void same_line_right(float width) {
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
}

std::string size_text(Extent extent) {
    return fmt::format("{} × {}", extent.width, extent.height);
}
