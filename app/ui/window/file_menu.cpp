#include "ui/window/file_menu.h"

#include "ui/library/unsaved_menu.h"
#include "ui/widgets/menu_items.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/widgets.h"

namespace {
void draw_recent_menu(const Scene& scene, Edits& edits) {
    const std::vector<std::string>& files = scene.window.recent.files;
    const bool is_open = ImGui::BeginMenu("Open recent", !files.empty());
    edits.mark("menu:Open recent");
    if (!is_open)
        return;
    for (const std::string& name : files) {
        const ScopedId id(name);
        const std::filesystem::path file(name);
        if (ImGui::MenuItem(menu_label(file.filename().string()).c_str()))
            edits.open_file(file);
        tooltip(name);
        edits.mark("menu:recent:" + file.filename().string());
    }
    ImGui::EndMenu();
}
}  // namespace

void draw_file_submenus(const Action& after, const Scene& scene, Edits& edits) {
    if (after.id == ActionId::open)
        draw_recent_menu(scene, edits);
    if (after.id == ActionId::restore_unsaved)
        draw_unsaved_menu(scene, edits);
    if (after.id == ActionId::previous_favourite)
        draw_menu_sections(MenuSection::Menu::file, scene, edits);
}
