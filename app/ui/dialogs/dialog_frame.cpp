#include "ui/dialogs/dialog_frame.h"

#include "gpu/input_event.h"
#include "lab/messages/messages.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <imgui/imgui_internal.h>

#include <algorithm>

void close_dialog(Edits& edits) {
    edits.arrange([](WindowState& window) { window.dialog = {}; });
}

namespace {
constexpr float max_height = 0.96f;  // of the window
}  // namespace

float list_height(float wanted, float rest) {
    const float room = ImGui::GetIO().DisplaySize.y * max_height - rest;
    return std::clamp(room, 4.0f * ImGui::GetFontSize(), wanted);
}

void draw_dialog_problem(const std::string& problem, Edits& edits) {
    if (problem.empty())
        return;
    const ScopedColor color(ImGuiCol_Text, theme::problem);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(problem.c_str());
    ImGui::PopTextWrapPos();
    edits.mark("dialog_problem");
}

void begin_attempt(Edits& edits) {
    edits.change([](Messages& messages) { messages.take_problem(); });  // an earlier one
}

void end_attempt(Edits& edits) {
    edits.change([](WindowState& window, Messages& messages) {
        if (auto problem = messages.take_problem())
            window.dialog.problem = std::move(*problem);
        else
            window.dialog = {};
    });
}

std::optional<std::string> draw_name_advice(const NameCheck& check, Edits& edits) {
    if (check.problem.empty())
        return std::nullopt;
    ImGui::AlignTextToFramePadding();
    draw_dialog_problem(check.problem, edits);
    if (check.suggestion.empty())
        return std::nullopt;
    const std::string label = fmt::format("Use \"{}\"", check.suggestion);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float width = ImGui::CalcTextSize(label.c_str()).x + 2.0f * style.FramePadding.x;
    const float right = ImGui::GetItemRectMax().x + style.ItemSpacing.x + width;
    if (right < ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x)
        ImGui::SameLine();
    const bool is_taken = ImGui::Button(
        elided_to_width(label, ImGui::GetContentRegionAvail().x - 2.0f * style.FramePadding.x)
            .c_str());
    edits.mark("dialog_suggestion");
    return is_taken ? std::optional(check.suggestion) : std::nullopt;
}

namespace {
// Whether Escape belongs to a list or menu above the dialog. Closes it, unless ImGui has.
bool take_escape_of_popup() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    const bool has_popup = context.OpenPopupStack.Size > context.BeginPopupStack.Size;
    bool& had_popup = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("##had_popup"));
    const bool is_taken = ImGui::IsKeyPressed(gpu::key::escape, false) && (has_popup || had_popup);
    had_popup = has_popup;
    if (is_taken && has_popup)
        ImGui::ClosePopupToLevel(context.BeginPopupStack.Size, true);
    return is_taken;
}
}  // namespace

DialogFrame::DialogFrame(const char* title, float width, const Scene& scene, Edits& edits,
                         bool escape_closes) {
    if (!ImGui::IsPopupOpen(title))
        ImGui::OpenPopup(title);
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({room.x * 0.5f, room.y * 0.5f}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {room.x * 0.94f, room.y * max_height});
    ImGui::SetNextWindowSize({std::min(width * ImGui::GetFontSize(), room.x * 0.94f), 0.0f});
    const ScopedStyle<ImVec2> padding(ImGuiStyleVar_WindowPadding,
                                      ImVec2(18.0f * scene.scale, 14.0f * scene.scale));
    const ScopedStyle<float> rounding(ImGuiStyleVar_WindowRounding, 6.0f * scene.scale);
    m_is_open =
        ImGui::BeginPopupModal(title, nullptr,
                               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
    if (!m_is_open)
        return;
    const ScopedFont strong(scene.fonts.strong);
    ImGui::TextUnformatted(title);
    ImGui::Spacing();
    if (!take_escape_of_popup() && escape_closes && ImGui::IsKeyPressed(gpu::key::escape, false))
        close_dialog(edits);
}

DialogFrame::~DialogFrame() {
    if (m_is_open)
        ImGui::EndPopup();
}

namespace {
// Enter, unless it activates the control that has the keyboard focus.
bool is_enter_pressed() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    const ImGuiIO& io = ImGui::GetIO();
    const bool has_focus = (io.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0 &&
                           !context.NavDisableHighlight && context.NavId != 0;
    if (has_focus && !io.WantTextInput)
        return false;
    return ImGui::IsKeyPressed(gpu::key::enter, false) ||
           ImGui::IsKeyPressed(gpu::key::pad_enter, false);
}
}  // namespace

bool draw_close_button(const char* label, Edits& edits, bool is_default) {
    ImGui::Spacing();
    const float width = ImGui::GetFontSize() * 6.5f;
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - width);
    const ScopedColor color(ImGuiCol_Button, is_default ? theme::accent_filled : theme::field);
    const bool is_entered = is_default && !ImGui::GetIO().WantTextInput && is_enter_pressed();
    const bool is_left = ImGui::Button(label, {width, 0.0f}) || is_entered;
    edits.mark("dialog_cancel");
    if (is_left)
        close_dialog(edits);
    return is_left;
}

bool draw_dialog_buttons(const char* label, bool can_do, Edits& edits, const char* closing) {
    ImGui::Spacing();
    const float width = ImGui::GetFontSize() * 6.5f;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float start = ImGui::GetWindowContentRegionMax().x - 2.0f * width - gap;
    ImGui::SetCursorPosX(std::max(start, ImGui::GetCursorPosX()));
    if (ImGui::Button(closing, {width, 0.0f}))
        close_dialog(edits);
    edits.mark("dialog_cancel");
    ImGui::SameLine();
    const ScopedDisabled disabled(!can_do);
    const ScopedColor color(ImGuiCol_Button, theme::accent_filled);
    const bool is_asked = ImGui::Button(label, {width, 0.0f}) || is_enter_pressed();
    edits.mark("dialog_ok");
    return is_asked && can_do;
}
