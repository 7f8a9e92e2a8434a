#include "ui/actions/pass_switch_actions.h"

#include "lab/frame/pass_control.h"
#include "lab/messages/messages.h"
#include "ui/actions/file_actions.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <fmt/format.h>

namespace {
std::string chosen_pass(const Scene& scene) {
    const Look& look = scene.lab.document->look();
    return look.passes[static_cast<std::size_t>(inspected_pass(look, scene.window.views.inspected))]
        .name;
}

void toggle(PassSwitch which, const std::string& pass, Edits& edits) {
    edits.change([which, pass](PassControl& passes) { passes.toggle(which, pass); });
}

template <PassSwitch which>
void toggle_chosen(const Scene& scene, Edits& edits) {
    toggle(which, chosen_pass(scene), edits);
}

template <PassSwitch which>
bool is_on(const Scene& scene) {
    return file_actions::has_document(scene) &&
           scene.lab.frames.passes().switches().has(which, chosen_pass(scene));
}

void clear_chosen(const Scene& scene, Edits& edits) {
    edits.change([pass = chosen_pass(scene)](PassControl& passes, Messages& messages) {
        passes.clear_history(pass);
        messages.say(fmt::format("The history of '{}' was cleared", pass));
    });
}

void clear_all(const Scene&, Edits& edits) {
    edits.change([](PassControl& passes, Messages& messages) {
        passes.clear_history();
        messages.say("The history of all passes was cleared");
    });
}

void switch_nothing(const Scene&, Edits& edits) {
    edits.change([](PassControl& passes) { passes.set({}); });
}

bool has_switches(const Scene& scene) {
    return !scene.lab.frames.passes().switches().is_empty();
}

template <PassSwitch which>
Action switching(ActionId id, const char* label, Chord chord, bool is_first = false) {
    return {id,
            Menu::pass,
            label,
            chord,
            is_first,
            toggle_chosen<which>,
            file_actions::has_document,
            is_on<which>};
}
}  // namespace

std::vector<Action> pass_switch_actions::list() {
    Action usual{ActionId::passes_as_usual,
                 Menu::pass,
                 "Clear solo, bypass and freeze",
                 {},
                 false,
                 switch_nothing,
                 has_switches};
    return {switching<PassSwitch::bypass>(ActionId::bypass_pass, "Bypass this pass",
                                          {'B', false, true}, true),
            switching<PassSwitch::solo>(ActionId::solo_pass, "Solo this pass", {'S'}),
            switching<PassSwitch::stop>(ActionId::stop_at_pass, "Stop at this pass",
                                        {'S', false, true}),
            switching<PassSwitch::freeze>(ActionId::freeze_pass, "Freeze this pass",
                                          {'F', false, true}),
            {ActionId::clear_pass,
             Menu::pass,
             "Clear pass history",
             {'H', false, true},
             true,
             clear_chosen,
             file_actions::has_document},
            {ActionId::clear_passes,
             Menu::pass,
             "Clear all passes' history",
             {'H'},
             false,
             clear_all,
             file_actions::has_document},
            usual};
}
