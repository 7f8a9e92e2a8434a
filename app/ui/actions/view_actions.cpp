#include "ui/actions/view_actions.h"

#include "gpu/input_event.h"
#include "ui/actions/file_actions.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/picture/picture_menus.h"
#include "ui/status/bottom_panels.h"

#include <algorithm>

namespace {
constexpr int key_f11 = gpu::key::first_function + 10;

template <bool WindowState::*shown>
void toggle(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.*shown = !(window.*shown); });
}

template <bool WindowState::*shown>
bool is_shown(const Scene& scene) {
    return scene.window.*shown;
}

// A menu item with a check mark while its pane is shown.
template <bool WindowState::*shown>
Action toggling(ActionId id, const char* label, Chord chord, bool is_first = false) {
    return {id, Menu::view, label, chord, is_first, toggle<shown>, nullptr, is_shown<shown>};
}

Action panel_action(const BottomPanel& panel) {
    Action action{panel.action, Menu::view, panel.title, panel.chord};
    action.act = [&panel](const Scene&, Edits& edits) {
        edits.arrange([&panel](WindowState& window) { toggle(panel, window); });
    };
    action.is_on = [&panel](const Scene& scene) { return is_chosen(panel, scene.window); };
    if (panel.needs_look)
        action.is_enabled = file_actions::has_document;
    return action;
}

// The history panel replaces the library panel while it is shown.
bool shows_library(const Scene& scene) {
    return scene.window.shows_library && !scene.window.shows_history;
}

void toggle_library(const Scene& scene, Edits& edits) {
    edits.arrange([is_shown = shows_library(scene)](WindowState& window) {
        window.shows_library = !is_shown;
        window.shows_history = false;
    });
}

void zoom_one(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.large_view() = {PictureView::Fit::free, 1.0}; });
}

void zoom_fit(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.large_view() = {PictureView::Fit::all}; });
}

template <bool is_in>
void zoom(const Scene& scene, Edits& edits) {
    const Extent picture = large_extent(scene);
    const Extent room = large_room(scene);
    edits.arrange([picture, room](WindowState& window) {
        PictureView& view = window.large_view();
        const double present = view.zoom_for(picture, room);
        view.zoom_about(view.x, view.y, present, next_zoom(present, is_in));
    });
}

void toggle_comfort(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.comfort.is_on = !window.comfort.is_on; });
}

bool has_comfort(const Scene& scene) {
    return scene.window.comfort.is_on;
}

template <int eighths>
void scale_text(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.scale = std::clamp(window.scale + eighths / 8.0, 0.75, 3.0);
    });
}
}  // namespace

void view_actions::search(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.shows_parameters = true;
        window.is_picture_only = false;
        window.is_searching = true;
    });
}

void view_actions::toggle_changed(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        const bool is_on = window.filter == ParameterFilter::changed;
        window.filter = is_on ? ParameterFilter::all : ParameterFilter::changed;
        window.shows_parameters = true;
    });
}

void view_actions::toggle_history(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.shows_history = !window.shows_history || window.is_picture_only;
        window.is_picture_only = false;
        window.history_seen = {};
    });
}

bool view_actions::shows_history(const Scene& scene) {
    return scene.window.shows_history;
}

bool view_actions::shows_only_changed(const Scene& scene) {
    return scene.window.filter == ParameterFilter::changed;
}

std::vector<Action> view_actions::list() {
    using State = WindowState;
    std::vector<Action> actions{
        {ActionId::zoom_one, Menu::view, "Zoom 1:1", {'1'}, true, zoom_one},
        {ActionId::zoom_fit, Menu::view, "Zoom to fit", {'F'}, false, zoom_fit},
        {ActionId::zoom_in, Menu::view, "Zoom in", {'='}, false, zoom<true>},
        {ActionId::zoom_out, Menu::view, "Zoom out", {'-'}, false, zoom<false>},
        {ActionId::show_library,
         Menu::view,
         "Looks and signal",
         {'1', true},
         true,
         toggle_library,
         nullptr,
         shows_library},
        toggling<&State::shows_parameters>(ActionId::show_parameters, "Parameters", {'2', true}),
        toggling<&State::shows_inspector>(ActionId::show_inspector, "Inspector", {'3', true}),
        toggling<&State::shows_strip>(ActionId::show_strip, "Pass strip", {'4', true})};
    for (const BottomPanel& panel : bottom_panels())
        actions.push_back(panel_action(panel));
    const std::vector<Action> others{
        toggling<&State::is_picture_only>(ActionId::picture_only, "Full screen", {key_f11}, true),
        toggling<&State::shows_flashes>(ActionId::show_flashes, "Flash meter", {}, true),
        {ActionId::comfort,
         Menu::view,
         "Flash limiter",
         {},
         false,
         toggle_comfort,
         nullptr,
         has_comfort},
        {ActionId::larger_text, Menu::view, "Larger text", {'=', true}, true, scale_text<1>},
        {ActionId::smaller_text, Menu::view, "Smaller text", {'-', true}, false, scale_text<-1>},
    };
    actions.insert(actions.end(), others.begin(), others.end());
    return actions;
}
