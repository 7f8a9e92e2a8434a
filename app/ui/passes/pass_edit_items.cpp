#include "ui/passes/pass_edit_items.h"

#include "ui/widgets/widgets.h"

#include <imgui/imgui.h>

void ask_for_pass(const std::string& after, const Scene& scene, Edits& edits) {
    const PassCommands& passes = scene.lab.looks.passes();
    if (passes.refusal(after))
        edits.change([after](LookCommands& looks) { looks.passes().refuse(after); });
    else
        edits.show({.kind = Dialog::Kind::add_pass,
                    .text = passes.proposed_name(after),
                    .subject = after});
}

void draw_pass_edits(const std::string& pass, const Scene& scene, Edits& edits) {
    if (ImGui::MenuItem("Add pass after…"))
        ask_for_pass(pass, scene, edits);
    edits.mark("pass_edit:add");
    for (const auto& [label, mark, where] :
         {std::tuple("Move earlier", "pass_edit:earlier", PassMove::earlier),
          std::tuple("Move later", "pass_edit:later", PassMove::later)}) {
        if (ImGui::MenuItem(label))
            edits.change(
                [pass, to = where](LookCommands& looks) { looks.passes().move(pass, to); });
        tooltip("A pass and its neighbour also exchange their inputs if one reads the other.");
        edits.mark(mark);
    }
    if (ImGui::MenuItem("Remove"))
        edits.change([pass](LookCommands& looks) { looks.passes().remove(pass); });
    tooltip("Passes that read it read its first input instead. Undo restores it.");
    edits.mark("pass_edit:remove");
}
