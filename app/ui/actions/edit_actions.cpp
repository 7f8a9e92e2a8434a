#include "ui/actions/edit_actions.h"

#include "lab/commands/preset_commands.h"
#include "lab/document/parameter_edits.h"
#include "lab/drawing/drawing_tool.h"
#include "ui/actions/file_actions.h"
#include "ui/actions/panel_actions.h"
#include "ui/actions/view_actions.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <fmt/format.h>

namespace {
bool can_undo(const Scene& scene) {
    return scene.lab.document &&
           (scene.lab.document->history().can_undo() || !scene.lab.presets.undo_name().empty());
}
bool can_redo(const Scene& scene) {
    return scene.lab.document && scene.lab.document->history().can_redo();
}
bool has_values(const Scene& scene) {
    return scene.lab.document && !scene.lab.document->values().empty();
}

void undo(const Scene&, Edits& edits) {
    edits.change([](PresetCommands& presets) { presets.undo(); });
}
void redo(const Scene&, Edits& edits) {
    edits.change([](Document& document) { document.redo(); });
}
void reset_all(const Scene&, Edits& edits) {
    edits.change(reset_all_parameters);
}
bool can_draw(const Scene& scene) {
    return scene.lab.document && scene.lab.document->look().driven_by == Driver::signal;
}
bool has_pen(const Scene& scene) {
    return scene.lab.drawing.board().has_pen();
}
void take_pen(const Scene& scene, Edits& edits) {
    edits.change(
        [is_active = !has_pen(scene)](DrawingTool& drawing) { drawing.take_pen(is_active); });
}
void show_remote(const Scene&, Edits& edits) {
    edits.show({.kind = Dialog::Kind::remote});
}

std::string undo_label(const Scene& scene) {
    if (!can_undo(scene))
        return "Undo";
    const std::string& of_presets = scene.lab.presets.undo_name();
    return fmt::format("Undo: {}",
                       of_presets.empty() ? scene.lab.document->history().undo_name() : of_presets);
}
std::string redo_label(const Scene& scene) {
    return can_redo(scene) ? fmt::format("Redo: {}", scene.lab.document->history().redo_name())
                           : "Redo";
}
}  // namespace

std::vector<Action> edit_actions::list() {
    std::vector<Action> actions{
        {ActionId::undo, Menu::edit, "Undo", {'Z', true}, false, undo, can_undo},
        {ActionId::redo, Menu::edit, "Redo", {'Z', true, true}, false, redo, can_redo},
        {ActionId::reset_all,
         Menu::edit,
         "Reset all parameters",
         {'R', true, true},
         true,
         reset_all,
         has_values},
        {ActionId::draw,
         Menu::edit,
         "Draw on the picture",
         {'D'},
         true,
         take_pen,
         can_draw,
         has_pen},
        {ActionId::search,
         Menu::edit,
         "Find a parameter",
         {'F', true},
         true,
         view_actions::search,
         file_actions::has_document},
        {ActionId::show_changed,
         Menu::edit,
         "Show only changed parameters",
         {'F', true, true},
         false,
         view_actions::toggle_changed,
         file_actions::has_document,
         view_actions::shows_only_changed},
        {ActionId::remote, Menu::edit, "Remote control…", {}, true, show_remote}};
    actions[0].current_label = undo_label;
    actions[1].current_label = redo_label;
    actions[2].undo_notice = "All unlocked parameters were reset";
    actions[3].undo_notice = "A drawing replaced the signal";
    const std::vector<Action> of_panels = panel_actions::list(Menu::edit);
    actions.insert(actions.begin() + 2, of_panels.begin(), of_panels.end());
    return actions;
}
