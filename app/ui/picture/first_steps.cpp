#include "ui/picture/first_steps.h"

#include "ui/frame/action.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

namespace {
// A ring; filled when done.
void draw_tick(bool is_done) {
    const float size = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 middle(low.x + size * 0.5f, low.y + size * 0.55f);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 color = ImGui::GetColorU32(is_done ? theme::accent : theme::dim);
    list.AddCircle(middle, size * 0.36f, color, 20, size * 0.09f);
    if (is_done)
        list.AddCircleFilled(middle, size * 0.20f, color, 16);
    ImGui::Dummy({size, size});
    ImGui::SameLine(0.0f, size * 0.6f);
}

void draw_step(bool is_done, const char* what, const std::string& how) {
    draw_tick(is_done);
    ImGui::BeginGroup();
    {
        const ScopedColor color(ImGuiCol_Text, is_done ? theme::dim : theme::text);
        ImGui::TextUnformatted(what);
    }
    wrapped_dim_text(how);
    ImGui::EndGroup();
    ImGui::Spacing();
}
}  // namespace

void note_first_steps(const Document* document, WindowState& window) {
    if (!document || !window.first_steps.is_shown)
        return;
    const DocumentState& state = document->state();
    const DocumentState& saved = document->opened_preset().saved;
    FirstSteps& steps = window.first_steps;
    steps.has_turned |= state.values != saved.values;
    steps.has_driven |= state.signal != saved.signal || state.source != saved.source;
    const std::string& inspected = window.views.inspected.pass;  // initially the last pass
    steps.has_looked |= !inspected.empty() && inspected != document->look().passes.back().name;
}

void draw_first_steps(const Scene& scene, Edits& edits) {
    const FirstSteps& steps = scene.window.first_steps;
    if (!steps.is_shown || scene.window.layout.is_picture_only)
        return;
    const float letter = ImGui::GetFontSize();
    const float margin = letter * 0.7f;
    const float width = letter * 19.0f;
    const ImVec2 room = ImGui::GetWindowSize();
    if (room.x < width + 2.0f * margin)
        return;
    ImGui::SetCursorPos({room.x - width - margin, margin});
    const ScopedColor back(ImGuiCol_ChildBg, theme::popup);
    const ScopedStyle<float> rounding(ImGuiStyleVar_ChildRounding, 6.0f * scene.scale);
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding, ImVec2(letter, letter * 0.8f));
    float& height =
        *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("##height"), letter * 13.0f);
    ImGui::BeginChild("##first_steps", {width, height}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
    {
        const ScopedFont font(scene.fonts.strong);
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(steps.are_done() ? "You're all set" : "Getting started");
    }
    same_line_right(ImGui::GetFrameHeight());
    if (icon_button("##close", Icon::close, "Don't show again", theme::dim))
        edits.arrange([](WindowState& window) { window.first_steps.is_shown = false; });
    edits.mark("first_steps:close");
    ImGui::Spacing();
    draw_step(steps.has_turned, "Adjust a parameter", "Drag a slider on the right.");
    draw_step(steps.has_driven, "Use your own media", "Drop a sound, picture or preset here.");
    draw_step(steps.has_looked, "Inspect a pass",
              fmt::format("Click a pass below. Press {} to edit its shader.",
                          scene.actions.key(ActionId::edit_pass)));
    wrapped_dim_text(fmt::format("Press {} to find any command and {} for all shortcuts.",
                                 scene.actions.key(ActionId::palette),
                                 scene.actions.key(ActionId::keys)));
    height = ImGui::GetCursorPosY() + letter * 0.4f;
    ImGui::EndChild();
    edits.mark("first_steps");
}
