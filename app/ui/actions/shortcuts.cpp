#include "ui/actions/shortcuts.h"

#include "gpu/input_event.h"
#include "lab/commands/content_commands.h"
#include "lab/commands/look_commands.h"
#include "lab/commands/preset_commands.h"
#include "lab/drawing/drawing_tool.h"
#include "lab/previews/previews.h"
#include "lab/reload/look_loader.h"
#include "lab/remote/remote_control.h"
#include "ui/frame/action.h"
#include "ui/frame/look_keys.h"
#include "ui/picture/overlays.h"

#include <imgui/imgui_internal.h>

#include <algorithm>

namespace {
// Keys that repeat while held.
bool repeats(int key) {
    return key == '.' || key == ',' || key == 'Z' ||
           (key >= gpu::key::right && key <= gpu::key::up);
}

// Keys of the control with the focus.
bool moves_focus(const Chord& chord) {
    return !chord.control &&
           (chord.key == gpu::key::enter || chord.key == gpu::key::pad_enter ||
            (chord.key >= gpu::key::right && chord.key <= gpu::key::page_down + 2));
}

bool is_pressed(const Chord& chord) {
    const ImGuiIO& io = ImGui::GetIO();
    return chord.key != 0 && io.KeyCtrl == chord.control && io.KeyShift == chord.shift &&
           !io.KeyAlt && ImGui::IsKeyPressed(chord.key, repeats(chord.key));
}

bool is_seek_key(const Chord& chord) {
    return chord.key == gpu::key::left || chord.key == gpu::key::right;
}

// Over a timeline, the arrow keys seek instead of changing the selected parameter.
void run_seek_keys(const Scene& scene, Edits& edits) {
    if (is_pressed({gpu::key::right}))
        run(ActionId::seek_forward, scene, edits);
    if (is_pressed({gpu::key::left}))
        run(ActionId::seek_back, scene, edits);
}

void end_line(Edits& edits) {
    edits.change([](DrawingTool& drawing) {
        drawing.edit([](DrawingBoard& board, Document& document) { board.end_line(document); });
    });
}

// Names what a key has discarded. Called after the effect of the action, whose edits come first.
void offer_undo(const Action& action, const Scene& scene, Edits& edits) {
    if (!action.undo_notice || !scene.lab.document)
        return;
    edits.change([text = action.undo_notice, before = scene.lab.document->state()](
                     const Document& document, Messages& messages) {
        if (document.state() != before)
            messages.offer(
                text, {.name = "Undo", .commands = {[](Document& changed) { changed.undo(); }}});
    });
}

// Escape cancels the topmost active item.
void escape(const Scene& scene, Edits& edits) {
    if (scene.is_behind_output)
        edits.arrange([](WindowState& window) { window.output.is_open = false; });
    else if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup))
        ImGui::ClosePopupToLevel(0, true);
    else if (scene.lab.drawing.board().open_line())
        end_line(edits);
    else if (!scene.lab.media.loading().empty())
        edits.change([](ContentCommands& content) { content.cancel_loading(); });
    else if (scene.lab.loader.opening())
        edits.change([](LookCommands& looks) { looks.cancel_opening(); });
    else if (scene.lab.renderer && scene.lab.renderer->replay().is_running())
        edits.change([](FrameLoop& frames) { frames.cancel_replay(); });
    else if (scene.lab.remote.midi().learning() || scene.lab.remote.midi().learning_command())
        edits.change([](RemoteControl& remote) { remote.end_midi_learning(); });
    else if (scene.lab.frames.previews().probe().request())
        edits.change([](Previews& previews) { previews.probe().stop(); });
    else if (scene.lab.presets.navigation().morphing())
        edits.change([](PresetCommands& presets) { presets.navigation().end_morph(); });
    else if (scene.lab.frames.previews().sheet().is_running())
        edits.change([](Previews& previews) { previews.sheet().cancel(); });
    else if (scene.lab.frames.comparison().selection().is_reference_shown())
        edits.change([](ComparisonView& comparison) { comparison.show_reference(false); });
    else if (shows_errors(scene))
        edits.change([](LookCommands& looks) { looks.dismiss_problems(); });
    else if (scene.window.views.shows_pass_large)
        edits.arrange([](WindowState& window) { window.views.shows_pass_large = false; });
    else if (scene.window.layout.is_picture_only)
        edits.arrange([](WindowState& window) { window.layout.is_picture_only = false; });
    else if (scene.lab.drawing.board().has_pen())
        edits.change([](DrawingTool& drawing) { drawing.take_pen(false); });
}
}  // namespace

void act_with_undo_notice(const Action& action, const Scene& scene, Edits& edits) {
    action.act(scene, edits);
    offer_undo(action, scene, edits);
}

void run_shortcuts(const Scene& scene, Edits& edits) {
    for (const Action& action : scene.actions.rows())
        if (action.on_release && ImGui::IsKeyReleased(action.chord.key))
            action.on_release(scene, edits);
    const KeyboardFocus& keyboard = scene.window.keyboard;
    const bool is_menu_open =
        keyboard.is_in_menus && (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) ||
                                 ImGui::GetCurrentContext()->NavLayer == ImGuiNavLayer_Menu);
    if (scene.window.dialog.kind != Dialog::Kind::none || is_menu_open)
        return;
    const bool is_typing = ImGui::GetIO().WantTextInput;  // also if Escape has just ended it
    // The plain keys of this frame may have closed a menu, or moved the focus.
    const bool has_plain_keys = !keyboard.is_in_menus && !is_typing;
    if (ImGui::IsKeyPressed(gpu::key::escape, false) && !ImGui::IsAnyItemActive() &&
        has_plain_keys && !keyboard.has_focus)
        escape(scene, edits);
    const bool is_entered = ImGui::IsKeyPressed(gpu::key::enter, false) ||
                            ImGui::IsKeyPressed(gpu::key::pad_enter, false);
    if (is_entered && has_plain_keys && scene.lab.drawing.board().open_line())
        end_line(edits);
    const bool are_seeking =
        scene.window.views.timeline.is_hovered && has_plain_keys && !keyboard.has_focus;
    if (are_seeking)
        run_seek_keys(scene, edits);
    for (const Action& action : scene.actions.rows()) {
        if (are_seeking && is_seek_key(action.chord))
            continue;
        // An active text field handles copy, paste, undo and letters. Other Ctrl shortcuts always
        // work.
        const bool is_text_field_s = !action.chord.control || action.id == ActionId::copy_line ||
                                     action.id == ActionId::paste_line ||
                                     action.id == ActionId::undo || action.id == ActionId::redo;
        const bool is_taken = (is_typing && is_text_field_s) ||
                              (keyboard.has_focus && moves_focus(action.chord)) ||
                              (!action.chord.control &&
                               (keyboard.is_in_menus || is_key_of_look(action.chord.key, scene)));
        if (!action.is_hidden && is_pressed(action.chord) && !is_taken && is_enabled(action, scene))
            act_with_undo_notice(action, scene, edits);
    }
    static constexpr Chord other_redo{'Y', true};
    const bool is_taken = std::ranges::any_of(
        scene.actions.rows(), [](const Action& action) { return action.chord == other_redo; });
    if (is_pressed(other_redo) && !is_typing && !is_taken)
        run(ActionId::redo, scene, edits);
}
