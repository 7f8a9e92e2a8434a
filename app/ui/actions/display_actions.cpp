#include "ui/actions/display_actions.h"

#include "gpu/displays.h"
#include "gpu/input_event.h"
#include "lab/messages/messages.h"
#include "lab/output/source_overlay.h"
#include "ui/actions/file_actions.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

namespace {
using file_actions::has_document;
constexpr int key_f12 = gpu::key::last_function;

bool has_output(const Scene& scene) {
    return scene.window.output.is_on();
}

bool shows_output(const Scene& scene) {
    return scene.window.output.is_open && !scene.window.output.is_overlay;
}

void toggle_output(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.output.toggle(false); });
}

bool shows_overlay(const Scene& scene) {
    return scene.window.output.is_open && scene.window.output.is_overlay;
}

void toggle_overlay(const Scene& scene, Edits& edits) {
    const auto refusal = overlay_refusal(scene.lab.document);
    if (!refusal || shows_overlay(scene))
        return edits.arrange([](WindowState& window) { window.output.toggle(true); });
    edits.change([refusal](Messages& messages) {
        messages.ask(refusal->text, refusal->buttons, "overlay");
    });
}

bool has_camera(const Scene& scene) {
    return scene.window.output.is_camera_on;
}

void toggle_camera(const Scene&, Edits& edits) {
    edits.arrange(
        [](WindowState& window) { window.output.is_camera_on = !window.output.is_camera_on; });
}

bool has_displays(const Scene&) {
    return gpu::Displays().count() > 1;
}

void next_output(const Scene& scene, Edits& edits) {
    const std::size_t count = gpu::Displays().count();
    const std::size_t next = (scene.output_monitor + 1) % count;
    edits.arrange([next](WindowState& window) {
        window.output.is_open = true;
        window.output.is_overlay = false;
        window.output.is_black = false;
        window.output.monitor = next;
    });
}

bool is_black(const Scene& scene) {
    return scene.window.output.is_black;
}

void blackout(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.output.is_black = !window.output.is_black; });
}

bool waits_for_display(const Scene& scene) {
    return scene.window.frame_rate.waits_for_display;
}

void toggle_waiting(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.frame_rate.waits_for_display = !window.frame_rate.waits_for_display;
    });
}

template <int cap>
Action capped(ActionId id, const char* label, bool is_first = false) {
    return {id,
            Menu::frame_rate,
            label,
            {},
            is_first,
            [](const Scene&, Edits& edits) {
                edits.arrange([](WindowState& window) { window.frame_rate.cap = cap; });
            },
            nullptr,
            [](const Scene& scene) { return scene.window.frame_rate.cap == cap; }};
}
}  // namespace

std::vector<Action> display_actions::list() {
    constexpr int no_cap = static_cast<int>(FrameRate::no_cap);
    return {
        {ActionId::show_output,
         Menu::output,
         "Output window",
         {key_f12},
         false,
         toggle_output,
         nullptr,
         shows_output},
        {ActionId::next_output,
         Menu::output,
         "Move output to next display",
         {key_f12, false, true},
         false,
         next_output,
         has_displays},
        {ActionId::show_overlay,
         Menu::output,
         "Overlay on source window",
         {key_f12, true, true},
         false,
         toggle_overlay,
         has_document,
         shows_overlay},
        {ActionId::virtual_camera,
         Menu::output,
         "Virtual camera",
         {},
         false,
         toggle_camera,
         has_document,
         has_camera},
        {ActionId::blackout,
         Menu::output,
         "Blackout",
         {'B', true},
         false,
         blackout,
         has_output,
         is_black},
        {ActionId::wait_for_display,
         Menu::frame_rate,
         "Vertical sync (vsync)",
         {},
         false,
         toggle_waiting,
         nullptr,
         waits_for_display},
        capped<0>(ActionId::cap_display, "Match display refresh rate", true),
        capped<30>(ActionId::cap_30, "Limit to 30 fps"),
        capped<60>(ActionId::cap_60, "Limit to 60 fps"),
        capped<120>(ActionId::cap_120, "Limit to 120 fps"),
        capped<no_cap>(ActionId::no_cap, "Unlimited"),
    };
}
