#include "ui/window/menu_keys.h"

#include "gpu/input_event.h"

#include <imgui/imgui.h>
#include <imgui/imgui_internal.h>

namespace {
constexpr int f10 = gpu::key::first_function + 9;

// One is open, or the keys stand on the bar.
bool is_in_menus() {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel) ||
           ImGui::GetCurrentContext()->NavLayer == ImGuiNavLayer_Menu;
}

// The toolkit moves among all that is on the screen with these keys, where it is let: they belong
// to the parameters.
void let_keys_walk(bool are_let) {
    ImGuiConfigFlags& flags = ImGui::GetIO().ConfigFlags;
    flags = are_let ? flags | ImGuiConfigFlags_NavEnableKeyboard
                    : flags & ~ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::GetIO().KeyMap[ImGuiKey_Space] = are_let ? gpu::key::enter : ' ';  // what takes an item
}
}  // namespace

void follow_menu_keys(const char* first, const Scene& scene, Edits& edits) {
    const bool is_asked = ImGui::IsKeyPressed(f10, false) && !scene.window.walks_menus &&
                          scene.window.dialog.kind == Dialog::Kind::none;
    if (is_asked) {
        ImGui::OpenPopup(first);
        let_keys_walk(true);
        // A pointer that rests where the menu opens has not chosen anything.
        ImGui::GetCurrentContext()->NavDisableMouseHover = true;
        ImGui::GetCurrentContext()->NavDisableHighlight = false;
        edits.arrange([](WindowState& window) { window.walks_menus = true; });
    } else if (scene.window.walks_menus && !is_in_menus()) {
        let_keys_walk(false);
        ImGui::SetWindowFocus(nullptr);
        edits.arrange([](WindowState& window) { window.walks_menus = false; });
    }
}
