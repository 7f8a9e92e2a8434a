#include "ui/widgets/choice_items.h"

#include "lab/choices/lab_choices.h"

#include <imgui/imgui.h>

void run(const MenuCommands& commands, Edits& edits) {
    struct Doing {
        Edits& edits;
        void operator()(const std::function<void(Document&)>& command) const {
            edits.document(command);
        }
        void operator()(const std::function<void(Lab&)>& command) const { edits.add(command); }
        void operator()(const std::function<void(WindowState&)>& command) const {
            edits.arrange(command);
        }
    };
    for (const MenuCommand& command : commands)
        std::visit(Doing{edits}, command);
}

void take(const Choice& choice, const std::string& id, Edits& edits) {
    if (choice.number || choice.text)
        edits.show({.kind = Dialog::Kind::asked, .subject = id});
    else
        run(choice.commands, edits);
}

void draw_choice_menus(ChoiceList::Place place, const Scene& scene, Edits& edits) {
    for (const ChoiceList& list :
         menu_choices(scene.lab, scene.window, scene.library_view.looks(), place)) {
        const bool is_open = ImGui::BeginMenu(list.word.c_str());
        edits.mark("menu:" + list.word);
        if (!is_open)
            continue;
        for (const Choice& choice : list.choices) {
            if (ImGui::MenuItem(choice.name.c_str(), nullptr, choice.is_present))
                take(choice, list.label_of(choice), edits);
            edits.mark("menu:" + list.label_of(choice));
        }
        ImGui::EndMenu();
    }
}
