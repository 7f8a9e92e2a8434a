#include "ui/actions/knob_actions.h"

#include "gpu/input_event.h"
#include "lab/document/parameter_edits.h"
#include "lab/window/parameter_list.h"
#include "model/tuning/one_step.h"
#include "ui/actions/file_actions.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <fmt/format.h>

namespace {
const Parameter* knob_in_hand(const Scene& scene) {
    return scene.lab.document()
               ? find_parameter(scene.lab.document()->look(), scene.window.revealed.parameter)
               : nullptr;
}

bool has_knob(const Scene& scene) {
    return knob_in_hand(scene) != nullptr;
}

template <int by>
void go(const Scene& scene, Edits& edits) {
    const Revealed& revealed = scene.window.revealed;
    const auto next =
        listed_beside(listed_parameters(*scene.lab.document(), query_of(scene.window)),
                      {.parameter = revealed.parameter, .component = revealed.component}, by);
    if (!next)
        return;
    edits.arrange([next](WindowState& window) {
        window.shows_parameters = true;
        window.is_picture_only = false;
        window.revealed = {
            .parameter = next->parameter, .is_new = true, .component = next->component};
    });
}

// An event parameter is on only while the key is held, as with the mouse.
bool is_trigger(const Scene& scene) {
    const Parameter* parameter = knob_in_hand(scene);
    return parameter && parameter->control == Control::event;
}

template <bool is_up>
void turn(const Scene& scene, Edits& edits) {
    const Document& document = *scene.lab.document();
    if (is_trigger(scene))
        return edits.set(scene.window.revealed.parameter, Value(1.0));
    const Parameter parameter = with_ends(
        *knob_in_hand(scene), setting_of(scene.window.revealed.parameter, document.knobs()));
    const auto next =
        one_step(parameter, document.value(parameter), scene.window.revealed.component, is_up);
    if (next)
        edits.set(parameter.name, *next);
    else
        edits.add([words = next.error().front().message](Lab& lab) { lab.messages().say(words); });
}

void let_go(const Scene& scene, Edits& edits) {
    if (is_trigger(scene) && scene.lab.document()->value(*knob_in_hand(scene)).number() != 0.0)
        edits.set(scene.window.revealed.parameter, Value(0.0));
    if (has_knob(scene))
        edits.finish();
}

void type(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.revealed.is_to_be_typed = true; });
}

void reset(const Scene& scene, Edits& edits) {
    edits.document([name = scene.window.revealed.parameter](Document& document) {
        reset_parameters(document, {name});
    });
}

void copy_name(const Scene& scene, Edits& edits) {
    edits.copy(scene.window.revealed.parameter);
}

Action turning(ActionId id, const char* label, int key, void (*act)(const Scene&, Edits&)) {
    Action action{id, Menu::knob, label, {key}, false, act, has_knob};
    action.let_go = let_go;
    return action;
}
}  // namespace

std::vector<Action> knob_actions::list() {
    namespace key = gpu::key;
    return {
        {ActionId::next_knob,
         Menu::knob,
         "Next parameter",
         {key::down},
         false,
         go<1>,
         file_actions::has_document},
        {ActionId::previous_knob,
         Menu::knob,
         "Previous parameter",
         {key::up},
         false,
         go<-1>,
         file_actions::has_document},
        turning(ActionId::turn_up, "Increase by one step", key::right, turn<true>),
        turning(ActionId::turn_down, "Decrease by one step", key::left, turn<false>),
        {ActionId::type_knob, Menu::knob, "Type a value", {key::enter}, false, type, has_knob},
        {ActionId::reset_knob,
         Menu::knob,
         "Reset parameter",
         {key::backspace},
         false,
         reset,
         has_knob},
        {ActionId::copy_knob_name,
         Menu::knob,
         "Copy parameter name",
         {},
         false,
         copy_name,
         has_knob},
    };
}
