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

// With this flag, ImGui's keyboard navigation covers all widgets. It is normally off, because the
// parameters use these keys.
void let_keys_walk(bool are_let) {
    ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
    flags = are_let ? flags | ImGuiConfigFlags_NavEnableKeyboard
                    : flags & ~ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::GetIO().KeyMap[ImGuiKey_Space] = are_let ? gpu::key::enter : ' ';  // activates an item
}
}  // namespace

void follow_menu_keys(const char* first, const Scene& scene, Edits& edits) {
    const bool is_asked = ImGui::IsKeyPressed(f10, false) && !scene.window.keyboard.is_in_menus &&
                          scene.window.dialog.kind == Dialog::Kind::none;
    if (is_asked) {
        ImGui::OpenPopup(first);
        let_keys_walk(true);
        // The stationary pointer must not select an item of the new menu.
        ImGui::GetCurrentContext()->NavDisableMouseHover = true;
        ImGui::GetCurrentContext()->NavDisableHighlight = false;
        edits.arrange([](WindowState& window) { window.keyboard.is_in_menus = true; });
    } else if (scene.window.keyboard.is_in_menus && !is_in_menus()) {
        let_keys_walk(false);
        ImGui::SetWindowFocus(nullptr);
        edits.arrange([](WindowState& window) { window.keyboard.is_in_menus = false; });
    }
}
