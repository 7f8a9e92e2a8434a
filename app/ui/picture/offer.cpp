#include "ui/picture/offer.h"

#include "ui/picture/compare_bar.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/menu_items.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <algorithm>

namespace {
float buttons_width(const Notice& notice) {
    const ImGuiStyle& style = ImGui::GetStyle();
    float width = ImGui::GetFrameHeight();
    for (const MenuEntry& button : notice.buttons)
        width += ImGui::CalcTextSize(button.name.c_str()).x + 2.0f * style.FramePadding.x +
                 style.ItemSpacing.x;
    return width;
}
}  // namespace

void draw_offer(const Notice& notice, const Scene& scene, Edits& edits) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImVec2 room = ImGui::GetWindowSize();
    const float pad = ImGui::GetFontSize() * 0.8f;
    const std::string text = wrapped(notice.text, room.x * 0.8f - 2.0f * pad);
    const ImVec2 text_size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 size(std::max(text_size.x, buttons_width(notice)) + 2.0f * pad,
                      text_size.y + style.ItemSpacing.y + ImGui::GetFrameHeight() + 2.0f * pad);
    ImGui::SetCursorPos(
        {(room.x - size.x) * 0.5f, room.y - compare_bar_height(scene) - pad - size.y});
    const ScopedColor back(ImGuiCol_ChildBg, theme::popup);
    const ScopedColor edge(ImGuiCol_Border, theme::line);
    const ScopedStyle<float> rounding(ImGuiStyleVar_ChildRounding, 6.0f * scene.scale);
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(pad, pad));
    keep_tooltips_above(ImGui::GetCursorScreenPos().y);
    ImGui::BeginChild("##offer", size, true,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
    {
        const ScopedColor color(ImGuiCol_Text, notice.is_problem ? theme::problem : theme::text);
        ImGui::TextUnformatted(text.c_str());
    }
    for (const MenuEntry& button : notice.buttons) {
        if (ImGui::Button(button.name.c_str()))
            run(button.commands, edits);
        edits.mark("offer:" + button.name);
        ImGui::SameLine();
    }
    if (icon_button("##leave", Icon::close, "Dismiss", theme::dim))
        edits.change([](Messages& messages) { messages.dismiss(); });
    edits.mark("offer_leave");
    ImGui::EndChild();
}
