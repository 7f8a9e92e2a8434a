#include "ui/picture/pass_switch_items.h"

#include "ui/frame/action.h"
#include "ui/widgets/widgets.h"

#include <imgui/imgui.h>

#include <array>

namespace {
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

void show_whole_picture(const Scene& scene, Edits& edits) {
    PassSwitches switches = scene.lab.frames.passes().switches();
    switches.solo.clear();
    switches.last.clear();
    edits.change([switches](PassControl& passes) { passes.set(switches); });
}

void draw_pass_switches(const std::string& pass, const Scene& scene, Edits& edits) {
    for (const MenuLine& item : switch_items) {
        const bool is_on = scene.lab.frames.passes().switches().has(item.which, pass);
        if (ImGui::MenuItem(item.label, nullptr, is_on))
            edits.change(
                [which = item.which, pass](PassControl& passes) { passes.toggle(which, pass); });
        tooltip(item.help);
        edits.mark(std::string("switch:") + item.label);
    }
    ImGui::Separator();
    if (ImGui::MenuItem(scene.actions.row(ActionId::clear_pass).label))
        edits.change([pass](PassControl& passes) { passes.clear_history(pass); });
    edits.mark("switch:clear");
    const Action& clear = scene.actions.row(ActionId::passes_as_usual);
    if (ImGui::MenuItem(clear.label, nullptr, false, is_enabled(clear, scene)))
        clear.act(scene, edits);
}

std::string pass_switch_text(std::size_t pass, const Look& look, const PassSwitches& switches) {
    if (switches.is_empty())
        return {};
    const std::vector<PassRun> runs = runs_of(look, switches);
    const std::string& name = look.passes[pass].name;
    std::string text = switches.solo == name ? "solo" : switches.last == name ? "stop" : "";
    const PassRun run = pass < runs.size() ? runs[pass] : PassRun::drawn;
    if (run != PassRun::drawn && !text.empty())
        text += " · ";
    if (run == PassRun::bypassed)
        text += "bypassed";
    else if (run == PassRun::frozen)
        text += "frozen";
    else if (run == PassRun::left_out)
        text += "not drawn";
    return text;
}
