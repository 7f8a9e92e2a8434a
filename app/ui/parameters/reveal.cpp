#include "ui/parameters/reveal.h"

#include "model/tuning/slider_range.h"
#include "ui/widgets/theme.h"

#include <algorithm>

bool is_to_be_shown(const std::vector<const Parameter*>& parameters,
                    const ParameterListing& listing) {
    return listing.revealed.is_new &&
           std::any_of(parameters.begin(), parameters.end(), [&](const Parameter* parameter) {
               return parameter->name == listing.revealed.parameter;
           });
}

void show_if_revealed(const Parameter& parameter, float top, const ParameterListing& listing,
                      Edits& edits) {
    const Revealed& revealed = listing.revealed;
    if (parameter.name != revealed.parameter)
        return;
    const float line = ImGui::GetFrameHeightWithSpacing();
    float bottom = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y;
    if (has_parts(parameter)) {  // below its label
        top += line * static_cast<float>(1 + revealed.component);
        bottom = top + ImGui::GetFrameHeight();
    }
    const float scroll = ImGui::GetScrollY();
    const bool is_hidden = top < scroll || bottom > scroll + ImGui::GetWindowHeight();
    constexpr float from_top = 0.3f;
    if (revealed.is_new && is_hidden)
        ImGui::SetScrollFromPosY(top - scroll, from_top);
    const ImVec2 corner = ImGui::GetWindowPos();
    const float shift = corner.y - scroll;
    const float right = corner.x + ImGui::GetWindowContentRegionMax().x;
    theme::Color tint = theme::accent;
    tint.alpha = 0.22f;
    ImGui::GetWindowDrawList()->AddRectFilled(
        {corner.x, top + shift - 1.0f}, {right, bottom + shift + 1.0f}, theme::packed(tint), 3.0f);
    edits.mark("revealed:" + parameter.name);
    const bool is_over = !revealed.is_new && ImGui::IsMouseClicked(0);
    edits.arrange([is_over](WindowState& state) {
        state.parameters.revealed.is_new = false;
        state.parameters.revealed.wants_focus = false;
        if (is_over)
            state.parameters.revealed = {};
    });
}
