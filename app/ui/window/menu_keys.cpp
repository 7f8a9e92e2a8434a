#include "ui/window/menu_keys.h"

#include "gpu/input_event.h"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

namespace {
constexpr int f10 = gpu::key::first_function + 9;

// Whether a menu is open or the menu bar has the keyboard focus.
bool is_in_menus() {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel) ||
           ImGui::GetCurrentContext()->NavLayer == ImGuiNavLayer_Menu;
}

// Whether Left or Right has moved from an open menu to another one, which is still closed.
bool is_at_closed_menu() {
    const ImGuiContext& g = *ImGui::GetCurrentContext();
    return g.NavWindow == g.CurrentWindow && g.NavLayer == ImGuiNavLayer_Menu && g.NavId != 0 &&
           !g.NavDisableHighlight && !g.NavMoveSubmitted && !g.NavMoveForwardToNextFrame &&
           !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
}

void open_menu(ImGuiID id) {
    ImGui::OpenPopup(id);
    // The stationary pointer must not select an item of the new menu.
    ImGui::GetCurrentContext()->NavDisableMouseHover = true;
    ImGui::GetCurrentContext()->NavDisableHighlight = false;
}

// The first menu becomes the one from which Left and Right move.
void select_menu(ImGuiID id) {
    ImGuiWindow& bar = *ImGui::GetCurrentWindow();
    const ImVec2 at = ImGui::GetCursorScreenPos() - bar.Pos;
    bar.NavLastIds[ImGuiNavLayer_Menu] = id;
    bar.NavRectRel[ImGuiNavLayer_Menu] = {at, at + ImVec2(1.0f, ImGui::GetFontSize())};
}
}  // namespace

void set_keyboard_navigation(bool is_enabled) {
    ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
    flags = is_enabled ? flags | ImGuiConfigFlags_NavEnableKeyboard
                       : flags & ~ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::GetIO().KeyMap[ImGuiKey_Space] =
        is_enabled ? gpu::key::enter : ' ';  // activates an item
}

void follow_menu_keys(const char* first, const Scene& scene, Edits& edits) {
    const bool has_dialog = scene.window.dialog.kind != Dialog::Kind::none;
    const bool is_open = is_in_menus() && !has_dialog;
    const bool is_asked =
        ImGui::IsKeyPressed(f10, false) && !scene.window.keyboard.is_in_menus && !has_dialog;
    if (is_open && ImGui::IsKeyPressed(gpu::key::escape, false))
        ImGui::GetCurrentContext()->NavDisableMouseHover = true;  // the pointer reopens no submenu
    if (is_asked) {
        select_menu(ImGui::GetID(first));
        open_menu(ImGui::GetID(first));
        set_keyboard_navigation(true);
        edits.arrange([](WindowState& window) { window.keyboard.is_in_menus = true; });
    } else if (is_open && !scene.window.keyboard.is_in_menus) {
        set_keyboard_navigation(true);
        edits.arrange([](WindowState& window) { window.keyboard.is_in_menus = true; });
    } else if (is_at_closed_menu() && scene.window.keyboard.is_in_menus) {
        open_menu(ImGui::GetCurrentContext()->NavId);
    } else if (!is_open && scene.window.keyboard.is_in_menus) {
        set_keyboard_navigation(scene.window.keyboard.has_focus);
        if (!scene.window.keyboard.has_focus)
            ImGui::SetWindowFocus(nullptr);
        edits.arrange([](WindowState& window) { window.keyboard.is_in_menus = false; });
    }
}
