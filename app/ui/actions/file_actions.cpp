#include "ui/actions/file_actions.h"

#include "gpu/input_event.h"
#include "lab/commands/look_commands.h"
#include "lab/commands/preset_commands.h"
#include "lab/document/opened_preset.h"
#include "lab/storage/name_check.h"
#include "ui/dialogs/look_export_dialog.h"
#include "ui/dialogs/send_dialog.h"
#include "ui/frame/edits.h"
#include "ui/frame/scene.h"

#include <imgui/imgui.h>

namespace {
void save_as(const Scene& scene, Edits& edits) {
    edits.show({.kind = Dialog::Kind::save_preset_as, .text = scene.lab.presets.proposed_name()});
}

void save(const Scene& scene, Edits& edits) {
    if (scene.lab.presets.can_save_over())
        edits.change([](PresetCommands& presets) { presets.save(); });
    else
        save_as(scene, edits);
}

void rename(const Scene& scene, Edits& edits) {
    const Document& document = *scene.lab.document;
    edits.show({.kind = Dialog::Kind::rename_preset,
                .text = preset_name(document),
                .subject = preset_file(document).string()});
}

void duplicate(const Scene& scene, Edits& edits) {
    edits.change([file = preset_file(*scene.lab.document)](PresetCommands& presets) {
        presets.duplicate(file);
    });
}

void remove(const Scene& scene, Edits& edits) {
    edits.change([file = preset_file(*scene.lab.document)](PresetCommands& presets) {
        presets.remove(file);
    });
}

void show_in_folder(const Scene& scene, Edits& edits) {
    edits.change([file = preset_file(*scene.lab.document)](PresetCommands& presets) {
        presets.show_in_folder(file);
    });
}

void new_look(const Scene& scene, Edits& edits) {
    edits.show({.kind = Dialog::Kind::new_look, .text = scene.lab.looks.proposed_id()});
}

template <int by>
void step_preset(const Scene& scene, Edits& edits) {
    edits.change([only_starred = scene.window.presets.only_starred](PresetCommands& presets) {
        presets.navigation().step(by, only_starred);
    });
}

template <int by>
void step_favourite(const Scene&, Edits& edits) {
    edits.change([](PresetCommands& presets) { presets.navigation().step(by, true); });
}

template <int by>
void morph_preset(const Scene& scene, Edits& edits) {
    edits.change([wanted = scene.window.presets](PresetCommands& presets) {
        presets.navigation().morph_by(by, wanted.morph_seconds, wanted.only_starred);
    });
}

void duplicate_look(const Scene& scene, Edits& edits) {
    edits.show({.kind = Dialog::Kind::duplicate_look,
                .text = valid_look_id(scene.lab.document->look().id) + "-copy"});
}

void copy_line(const Scene& scene, Edits& edits) {
    edits.copy(scene.lab.presets.sharing().line());
    edits.change([](Messages& messages) { messages.say("Copied the preset as one line of text"); });
}

void copy_picture(const Scene&, Edits& edits) {
    edits.copy_picture();
}

void paste_line(const Scene&, Edits& edits) {
    const char* text = ImGui::GetClipboardText();
    edits.change([line = std::string(text ? text : "")](PresetCommands& presets) {
        presets.sharing().paste(line);
    });
}

void restore_unsaved(const Scene& scene, Edits& edits) {
    edits.open_unsaved(scene.lab.looks.stash().files().front());
}

bool has_stashed_session(const Scene& scene) {
    return !scene.lab.looks.stash().files().empty();
}

void use_desktop_dialog(const Scene&, Edits& edits) {
    edits.arrange([](WindowState& window) {
        window.file_dialogs.uses_desktop = !window.file_dialogs.uses_desktop;
    });
}

bool uses_desktop_dialog(const Scene& scene) {
    return scene.window.file_dialogs.uses_desktop;
}

void quit(const Scene&, Edits& edits) {
    edits.quit();
}

template <Dialog::Kind kind>
void show(const Scene&, Edits& edits) {
    edits.show({.kind = kind});
}
}  // namespace

bool file_actions::has_document(const Scene& scene) {
    return scene.lab.document != nullptr;
}

bool file_actions::has_preset(const Scene& scene) {
    return scene.lab.document && !preset_file(*scene.lab.document).empty();
}

namespace {
bool is_slang(const Scene& scene) {
    return scene.lab.presets.sharing().can_save_slang();
}

bool can_save_over(const Scene& scene) {
    return scene.lab.presets.can_save_over();
}

std::vector<Action> preset_actions() {
    using file_actions::has_document;
    using file_actions::has_preset;
    return {
        {ActionId::save_preset, Menu::file, "Save preset", {'S', true}, true, save, has_document},
        {ActionId::save_preset_as,
         Menu::file,
         "Save preset as…",
         {'S', true, true},
         false,
         save_as,
         has_document},
        {ActionId::save_slangp,
         Menu::file,
         "Save as .slangp…",
         {},
         false,
         show<Dialog::Kind::save_slangp>,
         is_slang},
        {ActionId::rename_preset,
         Menu::file,
         "Rename preset…",
         {gpu::key::first_function + 1},
         false,
         rename,
         can_save_over},
        {ActionId::duplicate_preset,
         Menu::file,
         "Duplicate preset",
         {'D', true},
         false,
         duplicate,
         has_preset},
        {ActionId::delete_preset,
         Menu::file,
         "Delete preset",
         {gpu::key::del, false, true},
         false,
         remove,
         can_save_over},
        {ActionId::show_preset_in_folder,
         Menu::file,
         "Show preset in folder",
         {},
         false,
         show_in_folder,
         has_preset},
    };
}

std::vector<Action> preset_ring_actions() {
    using file_actions::has_document;
    return {
        {ActionId::next_preset,
         Menu::file,
         "Next preset",
         {gpu::key::page_down, true},
         false,
         step_preset<1>,
         has_document},
        {ActionId::previous_preset,
         Menu::file,
         "Previous preset",
         {gpu::key::page_up, true},
         false,
         step_preset<-1>,
         has_document},
        {ActionId::morph_to_next,
         Menu::file,
         "Morph to next preset",
         {gpu::key::page_down, true, true},
         false,
         morph_preset<1>,
         has_document},
        {ActionId::morph_to_previous,
         Menu::file,
         "Morph to previous preset",
         {gpu::key::page_up, true, true},
         false,
         morph_preset<-1>,
         has_document},
        {ActionId::next_favourite,
         Menu::file,
         "Next favourite preset",
         {gpu::key::page_down, false, true},
         false,
         step_favourite<1>,
         has_document},
        {ActionId::previous_favourite,
         Menu::file,
         "Previous favourite preset",
         {gpu::key::page_up, false, true},
         false,
         step_favourite<-1>,
         has_document},
    };
}

std::vector<Action> sharing_actions() {
    using Kind = Dialog::Kind;
    using file_actions::has_document;
    return {
        {ActionId::copy_line,
         Menu::file,
         "Copy preset as text",
         {'C', true},
         true,
         copy_line,
         has_document},
        {ActionId::paste_line,
         Menu::file,
         "Paste preset from text",
         {'V', true},
         false,
         paste_line},
        {ActionId::save_picture,
         Menu::file,
         "Save picture…",
         {'E', true},
         true,
         show<Kind::save_picture>,
         has_document},
        {ActionId::copy_picture,
         Menu::file,
         "Copy picture",
         {'C', true, true},
         false,
         copy_picture,
         has_document},
        {ActionId::export_frames,
         Menu::file,
         "Export video or image sequence…",
         {'M', true, true},
         false,
         show<Kind::export_frames>,
         has_document},
    };
}

std::vector<Action> program_actions() {
    using Kind = Dialog::Kind;
    using file_actions::has_document;
    return {
        {ActionId::export_look,
         Menu::file,
         "Export look…",
         {'X', true, true},
         false,
         export_look,
         has_document},
        {ActionId::send_to_retroarch,
         Menu::file,
         "Send to RetroArch…",
         {},
         false,
         send_look<0>,
         has_document},
        {ActionId::send_to_mpv, Menu::file, "Send to mpv…", {}, false, send_look<1>, has_document},
        {ActionId::save_pack,
         Menu::file,
         "Save pack…",
         {},
         false,
         show<Kind::save_pack>,
         has_document},
    };
}
}  // namespace

std::vector<Action> file_actions::list() {
    using Kind = Dialog::Kind;
    std::vector<Action> actions{
        {ActionId::open, Menu::file, "Open…", {'O', true}, false, show<Kind::open_file>},
        {ActionId::restore_unsaved,
         Menu::file,
         "Restore unsaved changes",
         {'O', true, true},
         false,
         restore_unsaved,
         has_stashed_session},
        {ActionId::new_look, Menu::file, "New look…", {'N', true}, true, new_look},
        {ActionId::duplicate_look,
         Menu::file,
         "Duplicate look…",
         {'D', true, true},
         false,
         duplicate_look,
         has_document},
    };
    const std::vector<Action> presets = preset_actions();
    actions.insert(actions.end(), presets.begin(), presets.end());
    const std::vector<Action> ring = preset_ring_actions();
    actions.insert(actions.end(), ring.begin(), ring.end());
    const std::vector<Action> sharing = sharing_actions();
    actions.insert(actions.end(), sharing.begin(), sharing.end());
    const std::vector<Action> programs = program_actions();
    actions.insert(actions.end(), programs.begin(), programs.end());
    actions.push_back({ActionId::use_desktop_dialog,
                       Menu::file,
                       "Use desktop file dialog",
                       {},
                       true,
                       use_desktop_dialog,
                       {},
                       uses_desktop_dialog});
    actions.push_back({ActionId::quit, Menu::file, "Quit", {'Q', true}, true, quit});
    return actions;
}
