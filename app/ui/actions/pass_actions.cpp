#include "ui/actions/pass_actions.h"

#include "gpu/input_event.h"
#include "gpu/renderdoc.h"
#include "lab/commands/look_commands.h"
#include "lab/document/stack_edits.h"
#include "lab/menus/window_menu.h"
#include "model/plan/parameter_use.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace {
bool has_passes(const Scene& scene) {
    return scene.lab.document && scene.lab.renderer;
}

// Also draws while the clock is paused, so that the captured frame has all passes.
void capture_with_renderdoc(const Scene&, Edits& edits) {
    gpu::capture_next_frame();
    edits.change([](FrameLoop& frames, Messages& messages) {
        frames.reapply();
        messages.say("Capturing the next frame. Open it in RenderDoc.");
    });
}

Action renderdoc_action() {
    Action action{ActionId::capture_frame, Menu::pass, "Capture with RenderDoc", {}, true,
                  capture_with_renderdoc,  has_passes};
    action.is_hidden = !gpu::has_renderdoc();
    return action;
}

bool has_overrides(const Scene& scene) {
    return scene.lab.document && !scene.lab.document->state().overrides.empty();
}

bool is_large(const Scene& scene) {
    return scene.window.views.shows_pass_large;
}

// Skips idle passes, which the picture does not use at present.
template <int by>
void choose_next(const Scene& scene, Edits& edits) {
    const Executor& executor = scene.lab.renderer->executor();
    const Look& look = executor.look();
    const auto current =
        static_cast<std::size_t>(inspected_pass(look, scene.window.views.inspected));
    const std::size_t next = next_used_pass(look, executor.plan(), current, by);
    edits.arrange([name = look.passes[next].name](WindowState& window) {
        window.views.inspected.inspect(name);
        window.layout.panels.show(panel_id::inspector);
    });
}

void toggle_large(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.views.shows_pass_large = !window.views.shows_pass_large;
    });
}

void choose_channels(const Scene&, Edits& edits) {
    constexpr int count = static_cast<int>(Channels::luminance) + 1;
    edits.arrange([](WindowState& window) {
        window.views.inspected.channels =
            static_cast<Channels>((static_cast<int>(window.views.inspected.channels) + 1) % count);
    });
}

template <int stops>
void expose(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.views.inspected.exposure =
            std::clamp(window.views.inspected.exposure + stops, -60.0, 60.0);
    });
}

// The levels are fitted later: the histogram may still be pending after a change of channels.
void fit_levels(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.layout.panels.show(panel_id::inspector);
        window.views.pending.levels = true;
    });
}

void reset_levels(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) { window.views.inspected.reset_levels(); });
}

bool has_levels(const Scene& scene) {
    return has_passes(scene) && scene.window.views.inspected.has_levels();
}

template <bool PassView::*overlay>
void toggle(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.views.inspected.*overlay = !(window.views.inspected.*overlay);
    });
}

template <bool PassView::*overlay>
bool is_on(const Scene& scene) {
    return scene.window.views.inspected.*overlay;
}

bool has_probe(const Scene& scene) {
    return has_passes(scene) && scene.window.probes.pointer;
}

void pin(const Scene& scene, Edits& edits) {
    edits.arrange([pin = pin_at(*scene.window.probes.pointer)](WindowState& window) {
        add_pin(window, pin);
    });
}

void save_pass(const Scene& scene, Edits& edits) {
    edits.show({.kind = Dialog::Kind::save_pass, .subject = scene.window.views.inspected.label()});
}

// The first error with a line: in this file, or else in any.
std::optional<Location> first_error(const Messages& messages, const std::filesystem::path& file) {
    std::optional<Location> first;
    for (const Problem& problem : messages.problems()) {
        const Diagnostic& found = problem.diagnostic;
        if (found.severity != Severity::error || found.line <= 0 || found.file.empty())
            continue;
        if (found.file == file)
            return Location{found.file, found.line};
        if (!first)
            first = Location{found.file, found.line};
    }
    return first;
}

// The pass's shader, or the error to correct.
void edit_shader(const Scene& scene, Edits& edits) {
    const Look& look = scene.lab.document->look();
    const auto pass = static_cast<std::size_t>(inspected_pass(look, scene.window.views.inspected));
    const Location shader{look.passes[pass].fragment.file, 1};
    const Location location = first_error(scene.lab.messages, shader.file).value_or(shader);
    if (location.file.empty())
        return edits.change([name = look.passes[pass].name](Messages& messages) {
            messages.say(
                fmt::format("\"{}\" is a pass that Afterglow adds. It has no shader file.", name),
                true);
        });
    edits.change([location](LookCommands& looks) { looks.open_in_editor(location); });
}

void write(const Scene&, Edits& edits) {
    edits.change([](LookCommands& looks) { looks.write_overrides(); });
}

void take_back(const Scene&, Edits& edits) {
    edits.change([](Document& document) { clear_overrides(document); });
}
}  // namespace

namespace {
std::vector<Action> looking_actions() {
    using View = PassView;
    return {{ActionId::fit_levels,
             Menu::pass,
             "Fit black and white",
             {'A'},
             true,
             fit_levels,
             has_passes},
            {ActionId::reset_levels,
             Menu::pass,
             "Reset black and white",
             {'A', false, true},
             false,
             reset_levels,
             has_levels},
            {ActionId::mark_flaws,
             Menu::pass,
             "Mark NaN (red), Inf (green), negative (blue)",
             {'X'},
             false,
             toggle<&View::marks_flaws>,
             has_passes,
             is_on<&View::marks_flaws>},
            {ActionId::mark_clipping,
             Menu::pass,
             "Mark clipped white (yellow), black (cyan)",
             {'X', false, true},
             false,
             toggle<&View::marks_clipping>,
             has_passes,
             is_on<&View::marks_clipping>},
            {ActionId::false_color,
             Menu::pass,
             "False colour",
             {'C', false, true},
             false,
             toggle<&View::is_false_color>,
             has_passes,
             is_on<&View::is_false_color>},
            {ActionId::pin, Menu::pass, "Pin pixel", {'K'}, true, pin, has_probe},
            {ActionId::save_pass,
             Menu::pass,
             "Save pass…",
             {'E', true, true},
             false,
             save_pass,
             has_passes}};
}
}  // namespace

std::vector<Action> pass_actions::list() {
    const auto action = [](ActionId id, const char* label, Chord chord, bool is_first,
                           void (*act)(const Scene&, Edits&)) {
        return Action{id, Menu::pass, label, chord, is_first, act, has_passes};
    };
    Action large = action(ActionId::pass_large, "Show pass large", {'P'}, true, toggle_large);
    large.is_on = is_large;
    Action written =
        action(ActionId::write_passes, "Save to look.json", {'W', true, true}, false, write);
    Action back = action(ActionId::passes_as_written, "Revert to look.json", {'L', true, true},
                         false, take_back);
    written.is_enabled = back.is_enabled = has_overrides;
    std::vector<Action> actions{
        action(ActionId::next_pass, "Next pass", {'N'}, false, choose_next<1>),
        action(ActionId::previous_pass, "Previous pass", {'N', false, true}, false,
               choose_next<-1>),
        large,
        action(ActionId::next_channels, "Next channel", {'C'}, false, choose_channels),
        action(ActionId::brighter, "One stop brighter", {'E'}, false, expose<1>),
        action(ActionId::darker, "One stop darker", {'E', false, true}, false, expose<-1>),
    };
    const std::vector<Action> looking = looking_actions();
    actions.insert(actions.end(), looking.begin(), looking.end());
    actions.insert(actions.end(), {action(ActionId::edit_pass, "Edit shader",
                                          {gpu::key::first_function + 3}, true, edit_shader),
                                   written, back});
    actions.push_back(renderdoc_action());
    return actions;
}
