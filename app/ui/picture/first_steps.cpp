#include "ui/picture/first_steps.h"

#include "ui/frame/action.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>

#include <array>

namespace {
// A box; with a check mark when done.
void draw_tick(bool is_done) {
    const float size = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const auto at = [&](float x, float y) {
        return ImVec2(low.x + size * x, low.y + size * (y + 0.05f));
    };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRect(at(0.10f, 0.10f), at(0.90f, 0.90f),
                 ImGui::GetColorU32(is_done ? theme::accent : theme::outline), size * 0.15f, 0,
                 size * 0.07f);
    if (is_done) {
        const std::array<ImVec2, 3> mark{at(0.28f, 0.52f), at(0.44f, 0.68f), at(0.74f, 0.32f)};
        list.AddPolyline(mark.data(), static_cast<int>(mark.size()),
                         ImGui::GetColorU32(theme::accent), 0, size * 0.11f);
    }
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
    const DocumentState& saved = opened_preset(*document).saved;
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
    if (!steps.has_driven) {
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + letter * 1.6f);
        if (ImGui::Button("Open file…"))
            run(ActionId::open, scene, edits);
        edits.mark("first_steps:open");
        ImGui::Spacing();
    }
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
