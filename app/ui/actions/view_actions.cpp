#include "ui/actions/view_actions.h"

#include "gpu/input_event.h"
#include "lab/views/flicker.h"
#include "ui/actions/panel_actions.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"
#include "ui/picture/picture_menus.h"

#include <algorithm>

namespace {
constexpr int key_f11 = gpu::key::first_function + 10;

void toggle_full_screen(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.layout.is_picture_only = !window.layout.is_picture_only;
    });
}

bool is_full_screen(const Scene& scene) {
    return scene.window.layout.is_picture_only;
}

void toggle_flashes(const Scene&, Edits& edits) {
    edits.arrange(
        [](WindowState& window) { window.flashes.shows_meter = !window.flashes.shows_meter; });
}

bool shows_flashes(const Scene& scene) {
    return scene.window.flashes.shows_meter;
}

void zoom_one(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.views.large() = {PictureView::Fit::free, 1.0};
    });
}

void zoom_fit(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.views.large() = {PictureView::Fit::whole}; });
}

template <bool is_in>
void zoom(const Scene& scene, Edits& edits) {
    const Extent picture = large_extent(scene);
    const Extent room = main_pane_size(scene);
    edits.arrange([picture, room](WindowState& window) {
        PictureView& view = window.views.large();
        const double current = view.zoom_for(picture, room);
        view.zoom_about(view.x, view.y, current, next_zoom(current, is_in));
    });
}

void toggle_comfort(const Scene&, Edits& edits) {
    edits.arrange(
        [](WindowState& window) { window.flashes.limit.is_on = !window.flashes.limit.is_on; });
}

bool has_comfort(const Scene& scene) {
    return scene.window.flashes.limit.is_on;
}

// The first time, with the warning.
void toggle_flicker(const Scene& scene, Edits& edits) {
    if (scene.window.flashes.flicker == Flicker::not_asked)
        return edits.change([](Messages& messages) { ask_about_flicker(messages); });
    edits.arrange([](WindowState& window) {
        const bool is_allowed = window.flashes.flicker == Flicker::allowed;
        window.flashes.flicker = is_allowed ? Flicker::refused : Flicker::allowed;
    });
}

bool allows_flicker(const Scene& scene) {
    return scene.window.flashes.flicker == Flicker::allowed;
}

void toggle_hdr(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.hdr.is_on = !window.hdr.is_on; });
}

bool has_hdr(const Scene& scene) {
    return scene.window.hdr.is_on;
}

template <int eighths>
void scale_text(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.geometry.scale = std::clamp(window.geometry.scale + eighths / 8.0, 0.75, 3.0);
    });
}
}  // namespace

void view_actions::search(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.layout.reveal(panel_id::parameters);
        window.parameters.is_searching = true;
    });
}

void view_actions::toggle_changed(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        const bool is_on = window.parameters.filter == ParameterFilter::changed;
        window.parameters.filter = is_on ? ParameterFilter::all : ParameterFilter::changed;
        window.layout.panels.show(panel_id::parameters);
    });
}

bool view_actions::shows_only_changed(const Scene& scene) {
    return scene.window.parameters.filter == ParameterFilter::changed;
}

std::vector<Action> view_actions::list() {
    std::vector<Action> actions{
        {ActionId::zoom_one, Menu::view, "Zoom 1:1", {'1'}, true, zoom_one},
        {ActionId::zoom_fit, Menu::view, "Zoom to fit", {'F'}, false, zoom_fit},
        {ActionId::zoom_in, Menu::view, "Zoom in", {'='}, false, zoom<true>},
        {ActionId::zoom_out, Menu::view, "Zoom out", {'-'}, false, zoom<false>}};
    std::vector<Action> of_panels = panel_actions::list(Menu::view);
    of_panels.front().is_first = true;
    actions.insert(actions.end(), of_panels.begin(), of_panels.end());
    const std::vector<Action> others{
        {ActionId::picture_only,
         Menu::view,
         "Full screen",
         {key_f11},
         true,
         toggle_full_screen,
         nullptr,
         is_full_screen},
        {ActionId::show_flashes,
         Menu::view,
         "Flash meter",
         {},
         true,
         toggle_flashes,
         nullptr,
         shows_flashes},
        {ActionId::limit_flashes,
         Menu::view,
         "Flash limiter",
         {},
         false,
         toggle_comfort,
         nullptr,
         has_comfort},
        {ActionId::preview_hdr, Menu::view, "HDR preview", {}, false, toggle_hdr, nullptr, has_hdr},
        {ActionId::allow_flicker,
         Menu::view,
         "Allow flicker",
         {},
         false,
         toggle_flicker,
         nullptr,
         allows_flicker},
        {ActionId::larger_text, Menu::view, "Larger text", {'=', true}, true, scale_text<1>},
        {ActionId::smaller_text, Menu::view, "Smaller text", {'-', true}, false, scale_text<-1>},
    };
    actions.insert(actions.end(), others.begin(), others.end());
    return actions;
}
