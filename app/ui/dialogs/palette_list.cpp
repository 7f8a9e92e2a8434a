#include "ui/dialogs/palette_list.h"

#include "lab/document/opened_preset.h"
#include "lab/menus/menu_sections.h"
#include "ui/dialogs/compare_dialog.h"
#include "ui/frame/action.h"
#include "ui/widgets/menu_items.h"

namespace {
const char* menu_name(Menu menu) {
    switch (menu) {
        case Menu::file:
            return "File";
        case Menu::edit:
            return "Edit";
        case Menu::parameter:
            return "Edit > Parameter";
        case Menu::view:
            return "View";
        case Menu::output:
            return "View > Output";
        case Menu::frame_rate:
            return "View > Frame rate";
        case Menu::compare:
            return "Compare";
        case Menu::pass:
            return "Pass";
        case Menu::playback:
            return "Playback";
        case Menu::help:
            return "Help";
    }
    return "";
}

constexpr const char* no_unsaved = "no unsaved changes";
constexpr const char* no_parameter = "no parameter is selected (use the Up and Down keys)";
}  // namespace

const char* sequencer_disabled_reason(ActionId id) {
    switch (id) {
        case ActionId::remove_loop_region:
            return "no loop region is set (drag in the ruler of the timeline)";
        case ActionId::play_cues:
        case ActionId::save_cues_as:
        case ActionId::close_cues:
            return "no cues are open (use Open cues…)";
        case ActionId::save_cues:
            return no_unsaved;
        case ActionId::add_preset_cue:
            return "no preset is open";
        default:
            return "not available now";
    }
}

const char* disabled_reason(const Action& action, const Scene& scene) {
    if (!action.is_enabled || action.is_enabled(scene))
        return "";
    if (action.id == ActionId::next_output)
        return "only one display is connected";
    if (action.id == ActionId::blackout)
        return "the output window and the virtual camera are off";
    if (!scene.lab.document)
        return action.id == ActionId::restore_unsaved ? no_unsaved : "no look is open";
    switch (action.id) {
        case ActionId::restore_unsaved:
            return no_unsaved;
        case ActionId::save_slangp:
            return "the open look isn't a RetroArch slang preset";
        case ActionId::rename_preset:
        case ActionId::delete_preset:
            return preset_file(*scene.lab.document).empty() ? "no preset is open"
                                                            : "shipped presets can't be changed";
        case ActionId::duplicate_preset:
        case ActionId::show_preset_in_folder:
            return "no preset is open";
        case ActionId::undo:
            return "nothing to undo";
        case ActionId::redo:
            return "nothing to redo";
        case ActionId::reset_all:
            return "no parameters are changed";
        case ActionId::recall_a:
        case ActionId::recall_b:
        case ActionId::recall_c:
        case ActionId::with_a:
        case ActionId::with_b:
        case ActionId::with_c:
            return "the slot is empty";
        case ActionId::increase_parameter:
        case ActionId::decrease_parameter:
        case ActionId::type_parameter:
        case ActionId::reset_parameter:
        case ActionId::copy_parameter_name:
            return no_parameter;
        case ActionId::save_automation:
            return "no automation is recorded";
        case ActionId::fit_gain:
            return "needs an absolute or squared difference view";
        case ActionId::fit_levels:
            return "the inspector is closed or still measuring";
        case ActionId::pin:
            return "the pointer isn't over a picture";
        case ActionId::draw:
            return "this look doesn't use a signal";
        case ActionId::passes_as_usual:
            return "solo, bypass and freeze are off";
        case ActionId::write_passes:
        case ActionId::passes_as_written:
            return "pass settings match look.json";
        default:
            return sequencer_disabled_reason(action.id);
    }
}

namespace {
void reveal(const std::string& parameter, Edits& edits) {
    edits.arrange([parameter](WindowState& window) {
        window.layout.reveal(panel_id::parameters);
        window.parameters.filter = ParameterFilter::all;
        window.parameters.search.clear();
        window.parameters.revealed = {parameter, true};
    });
}

void inspect(const std::string& pass, Edits& edits) {
    edits.arrange([pass](WindowState& window) {
        window.views.inspected.inspect(pass);
        window.layout.reveal(panel_id::inspector);
    });
}

void run_action(const std::string& label, const Scene& scene, Edits& edits) {
    for (const Action& action : scene.actions.rows())
        if (action.label == label && action.id != ActionId::palette)
            action.act(scene, edits);
}

void compare(const std::string& file, const Scene& scene, Edits& edits) {
    for (const ListedLook& look : scene.library_view.looks())
        for (const ListedLookPreset& preset : look.presets)
            if (preset.entry.file == file)
                return compare_preset(preset, scene, edits);
}

void add(std::vector<PaletteEntry> more, std::vector<PaletteEntry>& entries) {
    std::move(more.begin(), more.end(), std::back_inserter(entries));
}
}  // namespace

std::vector<PaletteEntry> palette_list(const Scene& scene) {
    std::vector<PaletteEntry> entries;
    for (const Action& action : scene.actions.rows())
        if (action.id != ActionId::palette && !action.is_hidden)
            entries.push_back({PaletteEntry::Kind::action,
                               action.label,
                               label_of(action, scene),
                               menu_name(action.menu),
                               {},
                               chord_text(action.chord),
                               disabled_reason(action, scene)});
    const Document* document = scene.lab.document;
    const std::vector<ListedLook>& looks = scene.library_view.looks();
    add(section_entries(menu_sections(scene.lab, scene.window, looks)), entries);
    add(palette_entries(document ? &document->look() : nullptr, looks), entries);
    if (document)
        add(difference_entries(document->look(), looks), entries);
    add(file_entries(scene.window.recent.files), entries);
    return entries;
}

void run(const PaletteEntry& entry, const Scene& scene, Edits& edits) {
    edits.arrange([id = entry.id](WindowState& window) { note_use(window.recent.commands, id); });
    switch (entry.kind) {
        case PaletteEntry::Kind::action:
            return run_action(entry.id, scene, edits);
        case PaletteEntry::Kind::look:
        case PaletteEntry::Kind::preset:
            return edits.open(entry.subject);
        case PaletteEntry::Kind::pass:
            return inspect(entry.subject, edits);
        case PaletteEntry::Kind::parameter:
            return reveal(entry.subject, edits);
        case PaletteEntry::Kind::menu_entry:
            return take(entry.menu_entry, entry.id, edits);
        case PaletteEntry::Kind::file:
            return edits.open_file(entry.subject);
        case PaletteEntry::Kind::difference:
            return compare(entry.subject, scene, edits);
    }
}
