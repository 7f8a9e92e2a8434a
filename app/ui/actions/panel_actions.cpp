#include "ui/actions/panel_actions.h"

#include "ui/actions/file_actions.h"
#include "ui/panels/panel_table.h"

namespace {
Action action_of(const Panel& panel) {
    Action action{ActionId::show_panel, panel.menu, panel.title, panel.chord};
    action.panel = panel.id;
    action.act = [&panel](const Scene&, Edits& edits) {
        edits.arrange([&panel](WindowState& window) { toggle(panel, window); });
    };
    action.is_on = [&panel](const Scene& scene) { return is_chosen(panel, scene.window); };
    if (panel.needs_look)
        action.is_enabled = file_actions::has_document;
    return action;
}
}  // namespace

std::vector<Action> panel_actions::list(Menu menu) {
    std::vector<Action> actions;
    for (const Panel& panel : panels())
        if (panel.menu == menu)
            actions.push_back(action_of(panel));
    return actions;
}
