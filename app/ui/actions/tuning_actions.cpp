#include "ui/actions/tuning_actions.h"

#include "lab/document/parameter_edits.h"
#include "ui/actions/file_actions.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/parameters/step_view.h"

namespace {
void randomise(const Scene& scene, Edits& edits) {
    edits.change([change = RandomChange{random_seed(), scene.window.parameters.random_strength}](
                     Document& document) { randomise_parameters(document, change); });
}

template <ParameterFilter filter>
bool is_filtered(const Scene& scene) {
    return scene.window.parameters.filter == filter;
}

template <ParameterFilter filter>
void toggle_filter(const Scene& scene, Edits& edits) {
    const ParameterFilter next = is_filtered<filter>(scene) ? ParameterFilter::all : filter;
    edits.arrange([next](WindowState& window) {
        window.parameters.filter = next;
        window.layout.panels.show(panel_id::parameters);
    });
}

// Without a slider under the pointer, as from the menu, it shows instructions.
template <bool is_up>
void show_step(const Scene& scene, Edits& edits) {
    if (scene.window.parameters.pointed)
        return ask_for_step(*scene.window.parameters.pointed, is_up, edits);
    edits.change(
        [](Messages& messages) { messages.say("Point at a parameter and hold U or Shift+U"); });
}

void end_step(const Scene&, Edits& edits) {
    edits.change([](Previews& previews) { previews.probe().stop(); });
}

std::vector<Action> step_actions() {
    Action up{ActionId::step_up,
              Menu::edit,
              "Preview one step up (hold)",
              {'U'},
              true,
              show_step<true>,
              file_actions::has_document};
    Action down = up;
    down.id = ActionId::step_down;
    down.label = "Preview one step down (hold)";
    down.chord.shift = true;
    down.is_first = false;
    down.act = show_step<false>;
    up.on_release = down.on_release = end_step;
    return {up, down};
}
}  // namespace

std::vector<Action> tuning_actions::list() {
    constexpr auto favourites = ParameterFilter::favourites;
    constexpr auto of_pass = ParameterFilter::of_pass;
    // The first two extend the group of display actions that precedes this list.
    std::vector<Action> actions{{ActionId::show_favourites,
                                 Menu::edit,
                                 "Show only favourites",
                                 {},
                                 false,
                                 toggle_filter<favourites>,
                                 file_actions::has_document,
                                 is_filtered<favourites>},
                                {ActionId::show_of_pass,
                                 Menu::edit,
                                 "Show this pass's parameters",
                                 {},
                                 false,
                                 toggle_filter<of_pass>,
                                 file_actions::has_document,
                                 is_filtered<of_pass>},
                                {ActionId::randomise,
                                 Menu::edit,
                                 "Randomise",
                                 {'R', true},
                                 true,
                                 randomise,
                                 file_actions::has_document}};
    actions.back().undo_notice = "Unlocked parameters were randomised";
    const std::vector<Action> steps = step_actions();
    actions.insert(actions.end() - 1, steps.begin(), steps.end());
    return actions;
}
