#include "ui/actions/pass_edit_actions.h"

#include "lab/menus/window_menu.h"
#include "ui/actions/file_actions.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/passes/pass_edit_items.h"

namespace {
std::string inspected_name(const Scene& scene) {
    const Look& look = scene.lab.document->look();
    return look.passes[static_cast<std::size_t>(inspected_pass(look, scene.window.views.inspected))]
        .name;
}

void add_pass(const Scene& scene, Edits& edits) {
    ask_for_pass(inspected_name(scene), scene, edits);
}

void remove_pass(const Scene& scene, Edits& edits) {
    edits.change(
        [pass = inspected_name(scene)](LookCommands& looks) { looks.passes().remove(pass); });
}

template <PassMove where>
void move_pass(const Scene& scene, Edits& edits) {
    edits.change(
        [pass = inspected_name(scene)](LookCommands& looks) { looks.passes().move(pass, where); });
}

void show_look_in_folder(const Scene&, Edits& edits) {
    edits.change([](LookCommands& looks) { looks.show_in_folder(); });
}
}  // namespace

std::vector<Action> pass_edit_actions::list() {
    const auto action = [](ActionId id, const char* label, bool is_first,
                           void (*act)(const Scene&, Edits&)) {
        return Action{id, Menu::pass, label, {}, is_first, act, file_actions::has_document};
    };
    return {
        action(ActionId::add_pass, "Add pass after…", true, add_pass),
        action(ActionId::remove_pass, "Remove pass", false, remove_pass),
        action(ActionId::move_pass_earlier, "Move pass earlier", false,
               move_pass<PassMove::earlier>),
        action(ActionId::move_pass_later, "Move pass later", false, move_pass<PassMove::later>),
        action(ActionId::show_look_in_folder, "Show look in folder", true, show_look_in_folder)};
}
