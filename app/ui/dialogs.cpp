#include "ui/dialogs.h"

#include "ui/asked_dialog.h"
#include "ui/compare_dialog.h"
#include "ui/dialog_frame.h"
#include "ui/export_dialog.h"
#include "ui/file_dialog.h"
#include "ui/help_dialogs.h"
#include "ui/impulse_dialog.h"
#include "ui/palette_dialog.h"
#include "ui/rates_dialog.h"
#include "ui/remote_dialog.h"
#include "ui/scoped.h"
#include "ui/theme.h"
#include "ui/widgets.h"

#include <imgui/imgui_stdlib.h>

#include <algorithm>

namespace {
struct Question {
    const char* title;
    const char* help;
    const char* label;
    void (Lab::*answer)(const std::string&);
    bool (*is_taken)(const Scene& scene, const std::string& name);
    void (Lab::*replace)(const std::string&) = nullptr;  // null: a taken name is refused
};

bool is_look(const Scene& scene, const std::string& name) {
    const auto& looks = scene.shelf.looks();
    return std::any_of(looks.begin(), looks.end(),
                       [&](const ShelfLook& look) { return look.entry.id == name; });
}

// A preset of the open look has that name, in its file or in the list.
bool is_preset(const Scene& scene, const std::string& name) {
    for (const ShelfLook& look : scene.shelf.looks())
        for (const ShelfPreset& preset : look.presets)
            if (scene.lab.document() && look.entry.id == scene.lab.document()->look().id &&
                preset.entry.name == name)
                return true;
    return false;
}

bool is_other_preset(const Scene& scene, const std::string& name) {
    return scene.lab.document() && scene.lab.document()->preset_file().stem() != name &&
           is_preset(scene, name);
}

// A dialog that asks for one name.
void draw_name_dialog(const Question& question, const Scene& scene, Edits& edits) {
    const DialogFrame frame(question.title, 26.0f, scene, edits);
    if (!frame.is_open())
        return;
    dim_text(question.help);
    std::string text = scene.window.dialog.text;
    if (scene.window.dialog.is_new) {
        ImGui::SetKeyboardFocusHere();
        edits.arrange([](WindowState& window) { window.dialog.is_new = false; });
    }
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::InputText("##name", &text, ImGuiInputTextFlags_AutoSelectAll))
        edits.arrange([text](WindowState& window) { window.dialog.text = text; });
    edits.mark("dialog_name");
    const bool is_taken = question.is_taken(scene, text);
    const bool replaces = is_taken && question.replace;
    if (is_taken) {
        const ScopedColor color(ImGuiCol_Text, theme::warning);
        ImGui::TextWrapped(replaces ? "'%s' is there already; it will be replaced."
                                    : "'%s' is there already; choose another name.",
                           text.c_str());
        edits.mark("dialog_taken");
    }
    if (!draw_dialog_buttons(replaces ? "Replace" : question.label,
                             !text.empty() && (!is_taken || replaces), edits))
        return;
    close_dialog(edits);
    edits.add([text, answer = replaces ? question.replace : question.answer](Lab& lab) {
        (lab.*answer)(text);
    });
}

void draw_delete_dialog(const Scene& scene, Edits& edits) {
    const DialogFrame frame("Delete the preset?", 26.0f, scene, edits);
    if (!frame.is_open())
        return;
    ImGui::TextWrapped("'%s' will be deleted from the disk. Its values stay in the window.",
                       scene.lab.document() ? scene.lab.document()->preset_name().c_str() : "");
    if (!draw_dialog_buttons("Delete", true, edits))
        return;
    close_dialog(edits);
    edits.add([](Lab& lab) { lab.delete_preset(); });
}

Question name_question(Dialog::Kind kind) {
    using Kind = Dialog::Kind;
    if (kind == Kind::rename_preset)
        return {"Rename the preset", "Its new name", "Rename", &Lab::rename_preset,
                is_other_preset};
    if (kind == Kind::new_look)
        return {"New look", "The name of its folder: small letters, digits, - and _", "Create",
                &Lab::new_look, is_look};
    if (kind == Kind::duplicate_look)
        return {"Duplicate this look", "The name of the copy's folder", "Duplicate",
                &Lab::duplicate_look, is_look};
    return {
        "Save the preset as", "A name for these values", "Save", &Lab::save_preset_as, is_preset,
        &Lab::replace_preset};
}
}  // namespace

void draw_dialogs(const Scene& scene, Edits& edits) {
    using Kind = Dialog::Kind;
    switch (scene.window.dialog.kind) {
        case Kind::none:
            return;
        case Kind::open_file:
        case Kind::choose_file:
        case Kind::choose_reference:
        case Kind::save_picture:
        case Kind::save_pass:
        case Kind::load_drawing:
        case Kind::save_drawing:
        case Kind::save_moves:
        case Kind::save_slangp:
        case Kind::export_frames:
            draw_file_dialog(scene, edits);
            return;
        case Kind::save_preset_as:
        case Kind::rename_preset:
        case Kind::new_look:
        case Kind::duplicate_look:
            draw_name_dialog(name_question(scene.window.dialog.kind), scene, edits);
            return;
        case Kind::delete_preset:
            draw_delete_dialog(scene, edits);
            return;
        case Kind::palette:
            draw_palette_dialog(scene, edits);
            return;
        case Kind::compare_preset:
            draw_compare_dialog(scene, edits);
            return;
        case Kind::remote:
            draw_remote_dialog(scene, edits);
            return;
        case Kind::impulse:
            draw_impulse_dialog(scene, edits);
            return;
        case Kind::rates:
            draw_rates_dialog(scene, edits);
            return;
        case Kind::keys:
            draw_keys_dialog(scene, edits);
            return;
        case Kind::about:
            draw_about_dialog(scene, edits);
            return;
        case Kind::exporting:
            draw_export_dialog(scene, edits);
            return;
        case Kind::asked:
            draw_asked_dialog(scene, edits);
            return;
    }
}
