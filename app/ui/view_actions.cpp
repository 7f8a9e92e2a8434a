#include "ui/view_actions.h"

#include <algorithm>

namespace {
constexpr int key_f11 = 300;

template <bool WindowState::*shown>
void toggle(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.*shown = !(window.*shown); });
}

template <bool WindowState::*shown>
bool is_shown(const Scene& scene) {
    return scene.window.*shown;
}

// Both share the bottom pane: the one that is not there comes, the one that is there goes.
template <bool timings>
void toggle_bottom(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.shows_bottom = !window.shows_bottom || window.shows_timings != timings;
        window.shows_timings = timings;
    });
}

template <bool timings>
bool is_bottom(const Scene& scene) {
    return scene.window.shows_bottom && scene.window.shows_timings == timings;
}

void zoom_one(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.picture = {PictureView::Fit::free, 1.0}; });
}

void zoom_fit(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.picture = {PictureView::Fit::all}; });
}

template <bool is_in>
void zoom(const Scene& scene, Edits& edits) {
    const Extent picture = scene.lab.picture_extent();
    edits.arrange([picture](WindowState& window) {
        PictureView& view = window.picture;
        const double present = view.zoom_for(picture, window.views.picture);
        view.zoom_about(view.x, view.y, present, next_zoom(present, is_in));
    });
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

std::vector<Action> view_actions::list() {
    using State = WindowState;
    return {
        {ActionId::zoom_one, Menu::view, "Zoom 1:1", {'1'}, true, zoom_one},
        {ActionId::zoom_fit, Menu::view, "Show all of the picture", {'F'}, false, zoom_fit},
        {ActionId::zoom_in, Menu::view, "Zoom in", {'='}, false, zoom<true>},
        {ActionId::zoom_out, Menu::view, "Zoom out", {'-'}, false, zoom<false>},
        {ActionId::show_library,
         Menu::view,
         "Looks and signal",
         {'1', true},
         true,
         toggle<&State::shows_library>,
         nullptr,
         is_shown<&State::shows_library>},
        {ActionId::show_parameters,
         Menu::view,
         "Parameters",
         {'2', true},
         false,
         toggle<&State::shows_parameters>,
         nullptr,
         is_shown<&State::shows_parameters>},
        {ActionId::show_inspector,
         Menu::view,
         "Inspector",
         {'3', true},
         false,
         toggle<&State::shows_inspector>,
         nullptr,
         is_shown<&State::shows_inspector>},
        {ActionId::show_strip,
         Menu::view,
         "Strip of passes",
         {'4', true},
         false,
         toggle<&State::shows_strip>,
         nullptr,
         is_shown<&State::shows_strip>},
        {ActionId::show_problems,
         Menu::view,
         "Problems",
         {'5', true},
         false,
         toggle_bottom<false>,
         nullptr,
         is_bottom<false>},
        {ActionId::show_timings,
         Menu::view,
         "Timings",
         {'6', true},
         false,
         toggle_bottom<true>,
         nullptr,
         is_bottom<true>},
        {ActionId::picture_only,
         Menu::view,
         "Only the picture",
         {key_f11},
         true,
         toggle<&State::is_picture_only>,
         nullptr,
         is_shown<&State::is_picture_only>},
        {ActionId::larger_text, Menu::view, "Larger text", {'=', true}, true, scale_text<1>},
        {ActionId::smaller_text, Menu::view, "Smaller text", {'-', true}, false, scale_text<-1>},
    };
}
