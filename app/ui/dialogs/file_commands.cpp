#include "ui/dialogs/file_commands.h"

#include "lab/commands/content_commands.h"
#include "lab/commands/look_commands.h"
#include "lab/commands/preset_commands.h"
#include "lab/document/automation.h"
#include "lab/drawing/drawing_tool.h"
#include "lab/jobs/background_jobs.h"
#include "lab/library/library_view.h"
#include "lab/sequencer/sequencer.h"
#include "lab/views/snapshot.h"
#include "ui/dialogs/dialog_frame.h"

namespace fs = std::filesystem;

namespace {
void save_pass(const fs::path& file, const Scene& scene, Edits& edits) {
    finish_dialog(edits, [view = scene.window.views.inspected, file](const Renderer& renderer,
                                                                     Messages& messages) {
        save_target(renderer, view, file, messages);
    });
}
}  // namespace

void finish_file_dialog(const fs::path& file, const Scene& scene, Edits& edits) {
    using Kind = Dialog::Kind;
    const Dialog& dialog = scene.window.dialog;
    if (const FileDialogKind* kind = file_dialog_kind(dialog.kind))
        edits.arrange([key = kind->folder_key, folder = file.parent_path()](WindowState& window) {
            window.file_dialogs.folders[key] = folder;
        });
    switch (dialog.kind) {
        case Kind::open_file:
            return finish_dialog(edits, [file](LookCommands& looks) { looks.open_file(file); });
        case Kind::choose_reference:
            return finish_dialog(
                edits, [file](ComparisonView& comparison) { comparison.compare_with_file(file); });
        case Kind::choose_photo:
            edits.change([file](BackgroundJobs& jobs) { jobs.matcher().open_photo(file); });
            return edits.show({.kind = Kind::match_photo});
        case Kind::choose_shown:
            edits.change([file](LookCommands& looks) { looks.open_file(file); });
            return edits.show({.kind = Kind::match_photo});
        case Kind::load_drawing:
            return finish_dialog(edits, [file](DrawingTool& drawing) { drawing.load(file); });
        case Kind::save_drawing:
            return finish_dialog(edits, [file](DrawingTool& drawing) { drawing.save(file); });
        case Kind::save_automation:
            return finish_dialog(edits, [file](Automation& automation) { automation.save(file); });
        case Kind::open_cues:
            return finish_dialog(edits,
                                 [file](Sequencer& sequencer) { sequencer.cues().open(file); });
        case Kind::save_cues:
            return finish_dialog(edits,
                                 [file](Sequencer& sequencer) { sequencer.cues().save_as(file); });
        case Kind::save_slangp:
            return finish_dialog(
                edits, [file](PresetCommands& presets) { presets.sharing().save_slang(file); });
        case Kind::save_pack:
            return finish_dialog(edits, [file](const Document& document, BackgroundJobs& jobs) {
                jobs.export_pack(argument_of(document.look()), file);
            });
        case Kind::save_pass:
            return save_pass(file, scene, edits);
        case Kind::choose_file:
            return finish_dialog(edits, [name = dialog.subject, file](ContentCommands& content) {
                content.choose_picture(name, file);
            });
        default:
            return close_dialog(edits);
    }
}
