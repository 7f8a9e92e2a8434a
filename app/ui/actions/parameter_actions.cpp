#include "ui/actions/parameter_actions.h"

#include "gpu/input_event.h"
#include "lab/document/parameter_edits.h"
#include "lab/window/parameter_list.h"
#include "model/tuning/one_step.h"
#include "ui/actions/file_actions.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <fmt/format.h>

namespace {
const Parameter* selected_parameter(const Scene& scene) {
    return scene.lab.document ? find_parameter(scene.lab.document->look(),
                                               scene.window.parameters.revealed.parameter)
                              : nullptr;
}

bool has_selected_parameter(const Scene& scene) {
    return selected_parameter(scene) != nullptr;
}

template <int by>
void go(const Scene& scene, Edits& edits) {
    const Revealed& revealed = scene.window.parameters.revealed;
    const auto next =
        listed_neighbour(listed_parameters(*scene.lab.document, query_of(scene.window)),
                         {.parameter = revealed.parameter, .component = revealed.component}, by);
    if (!next)
        return;
    edits.arrange([next](WindowState& window) {
        window.layout.reveal(panel_id::parameters);
        window.parameters.revealed = {
            .parameter = next->parameter, .is_new = true, .component = next->component};
    });
}

// An event parameter is on only while the key is held, as with the mouse.
bool is_trigger(const Scene& scene) {
    const Parameter* parameter = selected_parameter(scene);
    return parameter && parameter->control == Control::event;
}

template <bool is_up>
void change_by_step(const Scene& scene, Edits& edits) {
    const Document& document = *scene.lab.document;
    if (is_trigger(scene))
        return edits.set(scene.window.parameters.revealed.parameter, Value(1.0));
    const Parameter parameter = with_ends(
        *selected_parameter(scene),
        setting_of(scene.window.parameters.revealed.parameter, document.parameter_settings()));
    const auto next = one_step(parameter, document.value(parameter),
                               scene.window.parameters.revealed.component, is_up);
    if (next)
        edits.set(parameter.name, *next);
    else
        edits.change(
            [text = next.error().front().message](Messages& messages) { messages.say(text); });
}

void end_step(const Scene& scene, Edits& edits) {
    if (is_trigger(scene) && scene.lab.document->value(*selected_parameter(scene)).number() != 0.0)
        edits.set(scene.window.parameters.revealed.parameter, Value(0.0));
    if (has_selected_parameter(scene))
        edits.finish();
}

void type(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.parameters.revealed.wants_focus = true; });
}

void reset(const Scene& scene, Edits& edits) {
    edits.change([name = scene.window.parameters.revealed.parameter](Document& document) {
        reset_parameters(document, {name});
    });
}

void copy_name(const Scene& scene, Edits& edits) {
    edits.copy(scene.window.parameters.revealed.parameter);
}

Action step_action(ActionId id, const char* label, int key, void (*act)(const Scene&, Edits&)) {
    Action action{id, Menu::parameter, label, {key}, false, act, has_selected_parameter};
    action.on_release = end_step;
    return action;
}
}  // namespace

std::vector<Action> parameter_actions::list() {
    namespace key = gpu::key;
    return {
        {ActionId::next_parameter,
         Menu::parameter,
         "Next parameter",
         {key::down},
         false,
         go<1>,
         file_actions::has_document},
        {ActionId::previous_parameter,
         Menu::parameter,
         "Previous parameter",
         {key::up},
         false,
         go<-1>,
         file_actions::has_document},
        step_action(ActionId::increase_parameter, "Increase by one step", key::right,
                    change_by_step<true>),
        step_action(ActionId::decrease_parameter, "Decrease by one step", key::left,
                    change_by_step<false>),
        {ActionId::type_parameter,
         Menu::parameter,
         "Type a value",
         {key::enter},
         false,
         type,
         has_selected_parameter},
        {ActionId::reset_parameter,
         Menu::parameter,
         "Reset parameter",
         {key::backspace},
         false,
         reset,
         has_selected_parameter},
        {ActionId::copy_parameter_name,
         Menu::parameter,
         "Copy parameter name",
         {},
         false,
         copy_name,
         has_selected_parameter},
    };
}
