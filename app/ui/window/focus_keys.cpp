#include "ui/window/focus_keys.h"

#include "gpu/input_event.h"
#include "lab/window/file_dialog_kind.h"
#include "ui/widgets/theme.h"
#include "ui/window/menu_keys.h"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>

namespace {
constexpr int tab = gpu::key::enter + 1;

ImGuiWindow* main_window() {
    return ImGui::FindWindowByName(main_window_name);
}

// ImGui's tabbing visits only text fields, so the request is made here, for all controls. It is
// resolved while this frame's controls are drawn.
void move_focus(int direction) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    if (!context.NavWindow)
        ImGui::FocusWindow(main_window());
    if (!context.NavWindow)
        return;
    const bool is_first = context.NavId == 0;
    context.NavTabbingDir = is_first ? 0 : direction;
    ImGui::NavMoveRequestSubmit(
        ImGuiDir_None, direction < 0 ? ImGuiDir_Up : ImGuiDir_Down,
        ImGuiNavMoveFlags_Tabbing | ImGuiNavMoveFlags_FocusApi,
        ImGuiScrollFlags_KeepVisibleEdgeX | ImGuiScrollFlags_KeepVisibleEdgeY);
    context.NavTabbingResultFirst.Clear();
    context.NavTabbingCounter = -1;
}

// The panes, in the order in which they were drawn in the previous frame.
unsigned int next_pane(int direction) {
    const ImGuiWindow* root = main_window();
    if (!root || root->DC.ChildWindows.empty())
        return 0;
    const ImVector<ImGuiWindow*>& panes = root->DC.ChildWindows;
    const ImGuiWindow* current = ImGui::GetCurrentContext()->NavWindow;
    while (current && current->ParentWindow != root)
        current = current->ParentWindow;
    const auto* const found = std::find(panes.begin(), panes.end(), current);
    const int count = panes.size();
    const int index =
        found == panes.end() ? (direction > 0 ? -1 : 0) : static_cast<int>(found - panes.begin());
    return panes[(index + direction + count) % count]->ID;
}

// The first control of the pane, see begin_pane_focus().
void move_to_pane() {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    context.NavId = 0;
    move_focus(1);
    context.NavTabbingDir = 1;
}

void start(Edits& edits) {
    set_keyboard_navigation(true);
    ImGuiContext& context = *ImGui::GetCurrentContext();
    context.NavDisableHighlight = false;
    context.NavDisableMouseHover = true;
    edits.arrange([](WindowState& window) { window.keyboard.has_focus = true; });
}

void end(Edits& edits) {
    set_keyboard_navigation(false);
    ImGui::SetWindowFocus(nullptr);
    edits.arrange([](WindowState& window) { window.keyboard.has_focus = false; });
}

void end_in_dialog(Edits& edits) {
    set_keyboard_navigation(false);
    ImGui::GetCurrentContext()->NavDisableHighlight = true;
    edits.arrange([](WindowState& window) {
        window.keyboard.has_focus = window.keyboard.is_in_dialog = false;
    });
}

// Whether the dialog uses Tab in another way, or waits for a key.
bool has_own_tab(const Dialog& dialog) {
    return file_dialog_kind(dialog.kind) || dialog.kind == Dialog::Kind::palette ||
           (dialog.kind == Dialog::Kind::keys && !dialog.subject.empty());
}

bool is_any_button_pressed() {
    const ImGuiIO& io = ImGui::GetIO();
    return std::any_of(std::begin(io.MouseClicked), std::end(io.MouseClicked),
                       [](bool is) { return is; });
}
}  // namespace

namespace {
void follow_in_dialog(const Scene& scene, Edits& edits) {
    const KeyboardFocus& keyboard = scene.window.keyboard;
    const ImGuiIO& io = ImGui::GetIO();
    if (keyboard.has_focus && is_any_button_pressed())
        return end_in_dialog(edits);
    if (!ImGui::IsKeyPressed(tab) || io.KeyAlt || io.KeyCtrl || has_own_tab(scene.window.dialog))
        return;
    if (!keyboard.has_focus)
        start(edits);
    if (!keyboard.is_in_dialog)
        edits.arrange([](WindowState& window) { window.keyboard.is_in_dialog = true; });
    move_focus(io.KeyShift ? -1 : 1);
}
}  // namespace

void follow_focus_keys(const Scene& scene, Edits& edits) {
    const KeyboardFocus& keyboard = scene.window.keyboard;
    const ImGuiIO& io = ImGui::GetIO();
    if (keyboard.is_in_menus || scene.is_behind_output)
        return;
    if (scene.window.dialog.kind != Dialog::Kind::none)
        return follow_in_dialog(scene, edits);
    if (keyboard.is_in_dialog)
        return end_in_dialog(edits);
    const bool is_left = ImGui::IsKeyPressed(gpu::key::escape, false) && !ImGui::IsAnyItemActive();
    if (keyboard.has_focus && (is_left || is_any_button_pressed()))
        return end(edits);
    const bool is_pressed = ImGui::IsKeyPressed(tab) && !io.KeyAlt && !keyboard.is_in_look;
    // In a text field, Tab goes to the next field, unless a control already had the focus.
    if (is_pressed && !io.KeyCtrl && io.WantTextInput && !keyboard.has_focus)
        return;
    const bool is_tab = is_pressed && !io.KeyCtrl;
    const bool is_pane_key = is_pressed && io.KeyCtrl;
    if (is_pane_key)
        ImGui::GetCurrentContext()->NavWindowingTarget = nullptr;  // ImGui's own list of windows
    if (is_pressed && !keyboard.has_focus)
        start(edits);
    const int direction = io.KeyShift ? -1 : 1;
    if (is_tab)
        move_focus(direction);
    if (is_pane_key)
        edits.arrange([pane = next_pane(direction)](WindowState& window) {
            window.keyboard.wanted_pane = pane;
        });
    else if (keyboard.wanted_pane != 0) {
        move_to_pane();
        edits.arrange([](WindowState& window) { window.keyboard.wanted_pane = 0; });
    }
}

void begin_pane_focus(const Scene& scene) {
    if (scene.window.keyboard.wanted_pane == ImGui::GetCurrentWindow()->ID)
        ImGui::GetCurrentContext()->NavTabbingCounter = 1;  // its next control
}

void draw_focus_frame(const Scene& scene, Edits& edits) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    const ImGuiWindow* window = context.NavWindow;
    if (!scene.window.keyboard.has_focus || context.NavLayer != ImGuiNavLayer_Main)
        return;
    if (!context.NavIdIsAlive)
        context.NavId = 0;  // the control is gone
    if (!window || context.NavId == 0)
        return;
    const float thickness = std::max(1.0f, ImGui::GetFontSize() * 0.12f);
    ImRect frame = ImGui::WindowRectRelToAbs(const_cast<ImGuiWindow*>(window),
                                             window->NavRectRel[ImGuiNavLayer_Main]);
    frame.Expand(thickness);
    frame.ClipWithFull(window->OuterRectClipped);
    if (frame.IsInverted())
        return;
    ImGui::GetForegroundDrawList()->AddRect(frame.Min, frame.Max, theme::packed(theme::accent),
                                            ImGui::GetStyle().FrameRounding, 0, thickness);
    edits.mark("focus", {frame.Min.x, frame.Min.y, frame.Max.x, frame.Max.y});
}
