#include "ui/pass_switch_actions.h"

#include "ui/file_actions.h"
#include "ui/widgets.h"

#include <imgui/imgui.h>

#include <array>

namespace {
std::string chosen_pass(const Scene& scene) {
    const Look& look = scene.lab.document()->look();
    return look.passes[static_cast<std::size_t>(inspected_pass(look, scene.window))].name;
}

void toggle(PassSwitch which, const std::string& pass, Edits& edits) {
    edits.add([which, pass](Lab& lab) { lab.switch_pass(which, pass); });
}

template <PassSwitch which>
void toggle_chosen(const Scene& scene, Edits& edits) {
    toggle(which, chosen_pass(scene), edits);
}

template <PassSwitch which>
bool is_on(const Scene& scene) {
    return file_actions::has_document(scene) &&
           scene.lab.pass_switches().has(which, chosen_pass(scene));
}

void clear_chosen(const Scene& scene, Edits& edits) {
    edits.add([pass = chosen_pass(scene)](Lab& lab) { lab.clear_history(pass); });
}

void clear_all(const Scene&, Edits& edits) {
    edits.add([](Lab& lab) { lab.clear_history(); });
}

void switch_nothing(const Scene&, Edits& edits) {
    edits.add([](Lab& lab) { lab.set_pass_switches({}); });
}

bool has_switches(const Scene& scene) {
    return !scene.lab.pass_switches().is_empty();
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

constexpr const char* clear_label = "Clear solo, bypass and freeze";
constexpr const char* clear_history_label = "Clear pass history";

struct MenuLine {
    PassSwitch which;
    const char* label;
    const char* help;
};

constexpr std::array switch_items{
    MenuLine{PassSwitch::bypass, "Bypass", "Passes its first input through unchanged."},
    MenuLine{PassSwitch::solo, "Solo", "Shows only this pass instead of the picture."},
    MenuLine{PassSwitch::stop, "Stop here",
             "Shows this pass instead of the picture and skips later passes."},
    MenuLine{PassSwitch::freeze, "Freeze",
             "Keeps its last frame. Later passes continue to use it."},
};
}  // namespace

void pass_switch_actions::show_picture(const Scene& scene, Edits& edits) {
    PassSwitches switches = scene.lab.pass_switches();
    switches.solo.clear();
    switches.last.clear();
    edits.add([switches](Lab& lab) { lab.set_pass_switches(switches); });
}

void pass_switch_actions::draw_items(const std::string& pass, const Scene& scene, Edits& edits) {
    for (const MenuLine& item : switch_items) {
        const bool is_on = scene.lab.pass_switches().has(item.which, pass);
        if (ImGui::MenuItem(item.label, nullptr, is_on))
            toggle(item.which, pass, edits);
        tooltip(item.help);
        edits.mark(std::string("switch:") + item.label);
    }
    ImGui::Separator();
    if (ImGui::MenuItem(clear_history_label))
        edits.add([pass](Lab& lab) { lab.clear_history(pass); });
    edits.mark("switch:clear");
    if (ImGui::MenuItem(clear_label, nullptr, false, has_switches(scene)))
        switch_nothing(scene, edits);
}

std::string pass_switch_actions::words_of(std::size_t pass, const Look& look,
                                          const PassSwitches& switches) {
    if (switches.is_empty())
        return {};
    const std::vector<PassRun> runs = runs_of(look, switches);
    const std::string& name = look.passes[pass].name;
    std::string words = switches.solo == name ? "solo" : switches.last == name ? "stop" : "";
    const PassRun run = pass < runs.size() ? runs[pass] : PassRun::drawn;
    if (run != PassRun::drawn && !words.empty())
        words += " · ";
    if (run == PassRun::bypassed)
        words += "bypassed";
    else if (run == PassRun::frozen)
        words += "frozen";
    else if (run == PassRun::left_out)
        words += "not drawn";
    return words;
}

std::vector<Action> pass_switch_actions::list() {
    Action usual{ActionId::passes_as_usual,
                 Menu::pass,
                 clear_label,
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
             clear_history_label,
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
