#include "ui/widgets/menu_items.h"

#include "lab/menus/menu_sections.h"

#include <imgui/imgui.h>

void run(const std::vector<Edit>& commands, Edits& edits) {
    for (const Edit& command : commands)
        edits.change(command);
}

void take(const MenuEntry& entry, const std::string& id, Edits& edits) {
    if (entry.number || entry.text)
        edits.show({.kind = Dialog::Kind::asked, .subject = id});
    else
        run(entry.commands, edits);
}

void draw_menu_sections(MenuSection::Menu menu, const Scene& scene, Edits& edits) {
    for (const MenuSection& section :
         sections_of_menu(scene.lab, scene.window, scene.library_view.looks(), menu)) {
        const bool is_open = ImGui::BeginMenu(section.title.c_str());
        edits.mark("menu:" + section.title);
        if (!is_open)
            continue;
        for (const MenuEntry& entry : section.entries) {
            if (ImGui::MenuItem(entry.name.c_str(), nullptr, entry.is_present))
                take(entry, section.label_of(entry), edits);
            edits.mark("menu:" + section.label_of(entry));
        }
        ImGui::EndMenu();
    }
}
