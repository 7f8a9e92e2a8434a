#include "ui/window/menu_bar.h"

#include "lab/document/opened_preset.h"
#include "ui/frame/action_name.h"
#include "ui/picture/picture_menus.h"
#include "ui/widgets/menu_items.h"
#include "ui/widgets/remote_menu.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"
#include "ui/window/file_menu.h"
#include "ui/window/menu_keys.h"

#include <fmt/format.h>
#include <imgui/imgui_internal.h>

#include <array>

namespace {
void draw_item(const Action& action, const Scene& scene, Edits& edits) {
    if (action.is_first)
        ImGui::Separator();
    const std::string label = label_of(action, scene);
    const bool is_on = action.is_on && action.is_on(scene);
    if (ImGui::MenuItem(label.c_str(), chord_text(action.chord).c_str(), is_on,
                        is_enabled(action, scene)))
        action.act(scene, edits);
    edits.mark(std::string("menu:") + action.label);
    if (draw_remote_menu({action_command(action), action.label}, scene, edits) !=
        RemoteChoice::none)
        ImGui::ClosePopupToLevel(0, true);  // the whole menu
}

void draw_picture_submenus(const Scene& scene, Edits& edits) {
    if (ImGui::BeginMenu("Render size")) {
        draw_size_items(scene, edits);
        ImGui::EndMenu();
    }
    if (ImGui::BeginMenu("Zoom")) {
        draw_zoom_items(scene, edits);
        ImGui::EndMenu();
    }
}

// The sections of a menu, above the actions.
void draw_sections(Menu menu, const Scene& scene, Edits& edits) {
    using In = MenuSection::Menu;
    for (const auto& [of, section_menu] :
         {std::pair{Menu::edit, In::edit}, std::pair{Menu::compare, In::compare},
          std::pair{Menu::pass, In::pass}})
        if (of == menu)
            draw_menu_sections(section_menu, scene, edits);
}

void draw_menu(Menu menu, const char* label, const Scene& scene, Edits& edits);

void draw_submenus(Menu menu, const Scene& scene, Edits& edits) {
    if (menu == Menu::view) {
        draw_picture_submenus(scene, edits);
        draw_menu(Menu::output, "Output", scene, edits);
        draw_menu(Menu::frame_rate, "Frame rate", scene, edits);
    }
    if (menu == Menu::edit)
        draw_menu(Menu::parameter, "Parameter", scene, edits);
    draw_sections(menu, scene, edits);
}

void draw_menu(Menu menu, const char* label, const Scene& scene, Edits& edits) {
    const bool is_open = ImGui::BeginMenu(label);
    edits.mark(std::string("menu:") + label);
    if (!is_open)
        return;
    bool has_submenus = menu != Menu::edit;  // there, Undo and Redo come first
    if (has_submenus)
        draw_submenus(menu, scene, edits);
    for (const Action& action : scene.actions.rows())
        if (action.menu == menu && !action.is_hidden) {
            if (action.is_first && !has_submenus) {
                ImGui::Separator();
                draw_submenus(menu, scene, edits);
                has_submenus = true;
            }
            draw_item(action, scene, edits);
            if (menu == Menu::file)
                draw_file_submenus(action, scene, edits);
        }
    ImGui::EndMenu();
}

void draw_title(const Scene& scene) {
    const std::string title = title_of(scene.lab.document);
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    const float left = ImGui::GetWindowWidth() - width - ImGui::GetStyle().WindowPadding.x;
    if (left < ImGui::GetCursorPosX())
        return;
    ImGui::SetCursorPosX(left);
    dim_text(title);
}
}  // namespace

std::string title_of(const Document* document) {
    if (!document)
        return {};
    std::string title = document->look().name;
    if (!preset_name(*document).empty())
        title = fmt::format("{} – {}", title, preset_name(*document));
    return is_modified(*document) ? fmt::format("{} •", title) : title;
}

void draw_menu_bar(const Scene& scene, Edits& edits) {
    if (!ImGui::BeginMenuBar())
        return;
    follow_menu_keys("File", scene, edits);
    draw_menu(Menu::file, "File", scene, edits);
    draw_menu(Menu::edit, "Edit", scene, edits);
    draw_menu(Menu::view, "View", scene, edits);
    draw_menu(Menu::compare, "Compare", scene, edits);
    draw_menu(Menu::pass, "Pass", scene, edits);
    draw_menu(Menu::playback, "Playback", scene, edits);
    draw_menu(Menu::help, "Help", scene, edits);
    draw_title(scene);
    ImGui::EndMenuBar();
}
