#include "ui/actions.h"

#include "gpu/input_event.h"
#include "lab/trials/tryouts.h"
#include "ui/compare_actions.h"
#include "ui/display_actions.h"
#include "ui/file_actions.h"
#include "ui/impulse_dialog.h"
#include "ui/knob_actions.h"
#include "ui/look_keys.h"
#include "ui/overlays.h"
#include "ui/pass_actions.h"
#include "ui/pass_switch_actions.h"
#include "ui/rates_dialog.h"
#include "ui/tuning_actions.h"
#include "ui/view_actions.h"

#include <fmt/format.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace {
bool can_undo(const Scene& scene) {
    return scene.lab.document() &&
           (scene.lab.document()->history().can_undo() || !scene.lab.presets().undo_name().empty());
}
bool can_redo(const Scene& scene) {
    return scene.lab.document() && scene.lab.document()->history().can_redo();
}
bool has_values(const Scene& scene) {
    return scene.lab.document() && !scene.lab.document()->values().empty();
}

void undo(const Scene&, Edits& edits) {
    edits.add([](Lab& lab) { lab.undo(); });
}
void redo(const Scene&, Edits& edits) {
    edits.document([](Document& document) { document.redo(); });
}
void reset_all(const Scene&, Edits& edits) {
    edits.document([](Document& document) { document.reset_all(); });
}
bool can_draw(const Scene& scene) {
    return scene.lab.document() && scene.lab.document()->look().driven_by == Driver::signal;
}
bool has_pen(const Scene& scene) {
    return scene.lab.drawing_board().has_pen();
}
void take_pen(const Scene& scene, Edits& edits) {
    edits.add([is_in_hand = !has_pen(scene)](Lab& lab) { lab.take_pen(is_in_hand); });
}
void play_pause(const Scene& scene, Edits& edits) {
    const bool is_playing = scene.lab.player().is_playing();
    edits.add(
        [is_playing](Lab& lab) { is_playing ? lab.transport().pause() : lab.transport().play(); });
}
void step(const Scene&, Edits& edits) {
    edits.add([](Lab& lab) {
        lab.transport().pause();
        lab.transport().step();
    });
}
void restart(const Scene&, Edits& edits) {
    edits.add([](Lab& lab) { lab.restart(); });
}
template <int octaves>
void change_speed(const Scene& scene, Edits& edits) {
    const double speed = scene.lab.player().speed() * std::exp2(octaves);
    edits.add([speed](Lab& lab) { lab.transport().set_speed(speed); });
}
void set_normal_speed(const Scene&, Edits& edits) {
    edits.add([](Lab& lab) { lab.transport().set_speed(1.0); });
}

std::vector<Action> edit_actions() {
    return {{ActionId::undo, Menu::edit, "Undo", {'Z', true}, false, undo, can_undo},
            {ActionId::redo, Menu::edit, "Redo", {'Z', true, true}, false, redo, can_redo},
            {ActionId::show_history,
             Menu::edit,
             "History",
             {'H', true},
             false,
             view_actions::toggle_history,
             nullptr,
             view_actions::shows_history},
            {ActionId::reset_all,
             Menu::edit,
             "Reset all parameters",
             {'R', true, true},
             true,
             reset_all,
             has_values},
            {ActionId::draw,
             Menu::edit,
             "Draw on the picture",
             {'D'},
             true,
             take_pen,
             can_draw,
             has_pen},
            {ActionId::search,
             Menu::edit,
             "Find a parameter",
             {'F', true},
             true,
             view_actions::search,
             file_actions::has_document},
            {ActionId::show_changed,
             Menu::edit,
             "Show only changed parameters",
             {'F', true, true},
             false,
             view_actions::toggle_changed,
             file_actions::has_document,
             view_actions::shows_only_changed}};
}

std::vector<Action> playback_actions() {
    return {
        {ActionId::play_pause, Menu::playback, "Play or pause", {' '}, false, play_pause},
        {ActionId::step, Menu::playback, "Step one frame", {'.'}, false, step},
        {ActionId::restart, Menu::playback, "Restart", {'R'}, false, restart},
        {ActionId::slower, Menu::playback, "Halve speed", {'['}, true, change_speed<-1>},
        {ActionId::faster, Menu::playback, "Double speed", {']'}, false, change_speed<1>},
        {ActionId::normal_speed, Menu::playback, "Normal speed", {'\\'}, false, set_normal_speed},
        {ActionId::compare_rates,
         Menu::playback,
         "Compare frame rates…",
         {},
         true,
         [](const Scene&, Edits& edits) { compare_rates(edits); },
         file_actions::has_document},
        {ActionId::impulse,
         Menu::playback,
         "Measure impulse response…",
         {'I'},
         false,
         fire_impulse,
         file_actions::has_document}};
}

bool is_recording(const Scene& scene) {
    return scene.lab.moves().is_running();
}
bool has_moves(const Scene& scene) {
    return !scene.lab.moves().moves().empty();
}
// What was recorded is to be kept: the end asks where.
void record_moves(const Scene& scene, Edits& edits) {
    const bool is_starting = !is_recording(scene);
    edits.add([is_starting](Lab& lab) { lab.record_moves(is_starting); });
    if (!is_starting && has_moves(scene))
        edits.show({.kind = Dialog::Kind::save_moves});
}

std::vector<Action> moves_actions() {
    const auto save = [](const Scene&, Edits& edits) {
        edits.show({.kind = Dialog::Kind::save_moves});
    };
    const auto remote = [](const Scene&, Edits& edits) {
        edits.show({.kind = Dialog::Kind::remote});
    };
    return {{ActionId::record_moves,
             Menu::playback,
             "Record automation",
             {},
             true,
             record_moves,
             file_actions::has_document,
             is_recording},
            {ActionId::save_moves, Menu::playback, "Save automation…", {}, false, save, has_moves},
            {ActionId::remote, Menu::edit, "Remote control…", {}, true, remote}};
}

std::vector<Action> help_actions() {
    const auto keys = [](const Scene&, Edits& edits) { edits.show({.kind = Dialog::Kind::keys}); };
    const auto about = [](const Scene&, Edits& edits) {
        edits.show({.kind = Dialog::Kind::about});
    };
    const auto palette = [](const Scene&, Edits& edits) {
        edits.show({.kind = Dialog::Kind::palette});
    };
    return {
        {ActionId::palette, Menu::help, "Find a command…", {'P', true}, false, palette},
        {ActionId::keys, Menu::help, "Keyboard shortcuts", {gpu::key::first_function}, false, keys},
        {ActionId::about,
         Menu::help,
         "About Afterglow",
         {gpu::key::first_function, false, true},
         false,
         about}};
}

std::vector<Action> make_actions() {
    std::vector<Action> actions;
    for (const auto& part :
         {file_actions::list(), edit_actions(), tuning_actions::list(), knob_actions::list(),
          view_actions::list(), display_actions::list(), compare_actions::list(),
          pass_actions::list(), pass_switch_actions::list(), playback_actions(), moves_actions(),
          help_actions()})
        actions.insert(actions.end(), part.begin(), part.end());
    return actions;
}

// Held down, it does the same again and again.
bool repeats(int key) {
    return key == '.' || key == 'Z' || (key >= gpu::key::right && key <= gpu::key::up);
}

bool is_pressed(const Chord& chord) {
    const ImGuiIO& io = ImGui::GetIO();
    return chord.key != 0 && io.KeyCtrl == chord.control && io.KeyShift == chord.shift &&
           !io.KeyAlt && ImGui::IsKeyPressed(chord.key, repeats(chord.key));
}

bool can_run(const Action& action, const Scene& scene) {
    return !action.is_enabled || action.is_enabled(scene);
}

// Escape goes through what is in the way, nearest first.
void escape(const Scene& scene, Edits& edits) {
    if (scene.is_behind_output)
        edits.arrange([](WindowState& window) { window.output.is_open = false; });
    else if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup))
        ImGui::ClosePopupToLevel(0, true);
    else if (scene.lab.drawing_board().open_line())
        edits.end_line();
    else if (!scene.lab.drive().loading().empty())
        edits.add([](Lab& lab) { lab.cancel_loading(); });
    else if (scene.lab.opening())
        edits.add([](Lab& lab) { lab.cancel_opening(); });
    else if (scene.lab.renderer() && scene.lab.renderer()->replay().is_running())
        edits.add([](Lab& lab) { lab.cancel_replay(); });
    else if (scene.lab.midi().learning())
        edits.add([](Lab& lab) { lab.end_midi_learning(); });
    else if (scene.lab.tryouts().probe().question())
        edits.add([](Lab& lab) { lab.end_step(); });
    else if (scene.lab.morphing())
        edits.add([](Lab& lab) { lab.end_morph(); });
    else if (scene.lab.tryouts().sheet().is_running())
        edits.add([](Lab& lab) { lab.end_sheet(); });
    else if (scene.lab.comparing().is_flashing())
        edits.add([](Lab& lab) { lab.flash(false); });
    else if (shows_errors(scene))
        edits.add([](Lab& lab) { lab.put_problems_away(); });
    else if (scene.window.shows_pass_large)
        edits.arrange([](WindowState& window) { window.shows_pass_large = false; });
    else if (scene.window.is_picture_only)
        edits.arrange([](WindowState& window) { window.is_picture_only = false; });
    else if (has_pen(scene))
        take_pen(scene, edits);
}
}  // namespace

const std::vector<Action>& all_actions() {
    static const std::vector<Action> actions = make_actions();
    return actions;
}

void run(ActionId id, const Scene& scene, Edits& edits) {
    for (const Action& action : all_actions())
        if (action.id == id && can_run(action, scene))
            action.act(scene, edits);
}

namespace {
constexpr std::array<std::pair<int, const char*>, 10> named_keys{
    {{' ', "Space"},
     {gpu::key::enter, "Enter"},
     {gpu::key::backspace, "Backspace"},
     {gpu::key::del, "Delete"},
     {gpu::key::left, "Left"},
     {gpu::key::right, "Right"},
     {gpu::key::up, "Up"},
     {gpu::key::down, "Down"},
     {gpu::key::page_up, "PageUp"},
     {gpu::key::page_down, "PageDown"}}};
}  // namespace

std::string chord_text(const Chord& chord) {
    if (chord.key == 0)
        return {};
    std::string text = std::string(chord.control ? "Ctrl+" : "") + (chord.shift ? "Shift+" : "");
    for (const auto& [key, name] : named_keys)
        if (chord.key == key)
            return text + name;
    if (chord.key >= gpu::key::first_function && chord.key <= gpu::key::last_function)
        return text + "F" + std::to_string(chord.key - gpu::key::first_function + 1);
    return text + static_cast<char>(chord.key);
}

namespace {
const Action& action_of(ActionId id) {
    const auto& actions = all_actions();
    return *std::find_if(actions.begin(), actions.end(),
                         [id](const Action& action) { return action.id == id; });
}
}  // namespace

std::string key_of(ActionId id) {
    return chord_text(action_of(id).chord);
}

std::string help_of(ActionId id) {
    const std::string keys = key_of(id);
    const char* label = action_of(id).label;
    return keys.empty() ? label : fmt::format("{} ({})", label, keys);
}

std::string label_of(const Action& action, const Scene& scene) {
    const Document* document = scene.lab.document();
    if (document && action.id == ActionId::undo && can_undo(scene))
        return fmt::format("Undo: {}", scene.lab.presets().undo_name().empty()
                                           ? document->history().undo_name()
                                           : scene.lab.presets().undo_name());
    if (document && action.id == ActionId::redo && can_redo(scene))
        return fmt::format("Redo: {}", document->history().redo_name());
    return action.label;
}

void run_keys(const Scene& scene, Edits& edits) {
    for (const Action& action : all_actions())
        if (action.let_go && ImGui::IsKeyReleased(action.chord.key))
            action.let_go(scene, edits);
    if (scene.window.dialog.kind != Dialog::Kind::none || scene.window.walks_menus)
        return;
    if (ImGui::IsKeyPressed(gpu::key::escape, false) && !ImGui::IsAnyItemActive())
        escape(scene, edits);
    const bool is_typing = ImGui::GetIO().WantTextInput;
    const bool is_entered = ImGui::IsKeyPressed(gpu::key::enter, false) ||
                            ImGui::IsKeyPressed(gpu::key::pad_enter, false);
    if (is_entered && !is_typing && scene.lab.drawing_board().open_line())
        edits.end_line();
    const auto& actions = all_actions();
    for (const Action& action : actions) {
        // A text field has its own copy, paste, undo and letters; saving works from everywhere.
        const bool is_text_field_s = !action.chord.control || action.id == ActionId::copy_line ||
                                     action.id == ActionId::paste_line ||
                                     action.id == ActionId::undo || action.id == ActionId::redo;
        const bool is_of_look = !action.chord.control && is_key_of_look(action.chord.key, scene);
        if (is_pressed(action.chord) && !is_of_look && !(is_typing && is_text_field_s) &&
            can_run(action, scene))
            action.act(scene, edits);
    }
    const bool is_second_redo = is_pressed({'Y', true}) && !is_typing;
    if (is_second_redo && can_redo(scene))
        redo(scene, edits);
}
