#include "ui/dialogs/dialogs.h"

#include "lab/commands/look_commands.h"
#include "lab/commands/preset_commands.h"
#include "lab/storage/display_name.h"
#include "ui/dialogs/add_pass_dialog.h"
#include "ui/dialogs/compare_dialog.h"
#include "ui/dialogs/dialog_frame.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/file_dialog.h"
#include "ui/dialogs/help_dialogs.h"
#include "ui/dialogs/impulse_dialog.h"
#include "ui/dialogs/keys_dialog.h"
#include "ui/dialogs/live_dialog.h"
#include "ui/dialogs/look_export_dialog.h"
#include "ui/dialogs/match_dialog.h"
#include "ui/dialogs/name_field.h"
#include "ui/dialogs/new_look_dialog.h"
#include "ui/dialogs/palette_dialog.h"
#include "ui/dialogs/prompt_dialog.h"
#include "ui/dialogs/rates_dialog.h"
#include "ui/dialogs/remote_dialog.h"
#include "ui/dialogs/send_dialog.h"
#include "ui/dialogs/still_dialog.h"
#include "ui/widgets/scoped.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

#include <algorithm>
#include <array>

namespace {
struct Question {
    const char* title;
    const char* help;
    const char* label;
    void (*answer)(Edits& edits, const std::string& name, const std::string& subject);
    NameCheck (*check)(std::string_view name);
    bool (*is_taken)(const Scene& scene, const std::string& name);
    // Null: an existing name is refused.
    void (*replace)(Edits& edits, const std::string& name, const std::string& subject) = nullptr;
};

bool is_look(const Scene& scene, const std::string& name) {
    const auto& looks = scene.library_view.looks();
    return std::any_of(looks.begin(), looks.end(),
                       [&](const ListedLook& look) { return look.entry.id == name; });
}

// Whether the user has a preset with this name for the open look. Shipped presets do not count.
bool is_preset(const Scene& scene, const std::string& name) {
    for (const ListedLook& look : scene.library_view.looks())
        for (const ListedLookPreset& preset : look.presets)
            if (scene.lab.document && look.entry.id == scene.lab.document->look().id &&
                preset.entry.name == name && !preset.entry.is_shipped)
                return true;
    return false;
}

bool is_other_preset(const Scene& scene, const std::string& name) {
    return std::filesystem::path(scene.window.dialog.subject).stem() != name &&
           is_preset(scene, name);
}

void draw_taken(const std::string& name, bool replaces, Edits& edits) {
    const ScopedColor color(ImGuiCol_Text, theme::warning);
    ImGui::TextWrapped(replaces ? "\"%s\" already exists and will be replaced."
                                : "\"%s\" already exists. Choose another name.",
                       name.c_str());
    edits.mark("dialog_taken");
}

// A dialog with one text field for a name.
void draw_name_dialog(const Question& question, const Scene& scene, Edits& edits) {
    const DialogFrame frame(question.title, 26.0f, scene, edits);
    if (!frame.is_open())
        return;
    dim_text(question.help);
    const std::string text = draw_name_field(scene, edits);
    if (scene.window.dialog.kind == Dialog::Kind::save_preset_as)
        wrapped_dim_text(
            fmt::format("Saved in {}", display_folder(scene.lab.presets.destination())));
    const NameCheck check = question.check(text);
    if (const auto suggestion = draw_name_advice(check, edits))
        replace_name(*suggestion, edits);
    const bool is_taken = check.is_valid && question.is_taken(scene, text);
    const bool replaces = is_taken && question.replace;
    if (is_taken)
        draw_taken(text, replaces, edits);
    else if (check.problem.empty())
        draw_dialog_problem(scene.window.dialog.problem, edits);
    if (!draw_dialog_buttons(replaces ? "Replace" : question.label,
                             check.is_valid && (!is_taken || replaces), edits))
        return;
    const auto answer = replaces ? question.replace : question.answer;
    answer(edits, text, scene.window.dialog.subject);
}

using Text = const std::string&;

void rename_preset(Edits& edits, Text name, Text file) {
    finish_dialog(edits, [name, file](PresetCommands& presets) { presets.rename(file, name); });
}

void save_preset(Edits& edits, Text name, Text) {
    finish_dialog(edits, [name](PresetCommands& presets) { presets.save_as(name); });
}

void replace_preset(Edits& edits, Text name, Text) {
    finish_dialog(edits, [name](PresetCommands& presets) { presets.replace(name); });
}

void duplicate_look(Edits& edits, Text name, Text) {
    finish_dialog(edits, [name](LookCommands& looks) { looks.duplicate(name); });
}

Question name_question(Dialog::Kind kind) {
    using Kind = Dialog::Kind;
    constexpr const char* folder_help = "Folder name (lowercase letters, digits, - and _)";
    if (kind == Kind::rename_preset)
        return {"Rename preset", "New name",        "Rename",
                rename_preset,   check_preset_name, is_other_preset};
    if (kind == Kind::duplicate_look)
        return {"Duplicate look", folder_help, "Duplicate", duplicate_look, check_look_id, is_look};
    return {"Save preset as",  "Preset name", "Save",        save_preset,
            check_preset_name, is_preset,     replace_preset};
}
void draw_named(const Scene& scene, Edits& edits) {
    draw_name_dialog(name_question(scene.window.dialog.kind), scene, edits);
}

struct DialogRow {
    Dialog::Kind kind;
    void (*draw)(const Scene& scene, Edits& edits);
};
constexpr std::array dialog_rows{
    DialogRow{Dialog::Kind::save_preset_as, draw_named},
    DialogRow{Dialog::Kind::rename_preset, draw_named},
    DialogRow{Dialog::Kind::duplicate_look, draw_named},
    DialogRow{Dialog::Kind::new_look, draw_new_look_dialog},
    DialogRow{Dialog::Kind::add_pass, draw_add_pass_dialog},
    DialogRow{Dialog::Kind::palette, draw_palette_dialog},
    DialogRow{Dialog::Kind::compare_preset, draw_compare_dialog},
    DialogRow{Dialog::Kind::remote, draw_remote_dialog},
    DialogRow{Dialog::Kind::match_photo, draw_match_dialog},
    DialogRow{Dialog::Kind::impulse, draw_impulse_dialog},
    DialogRow{Dialog::Kind::rates, draw_rates_dialog},
    DialogRow{Dialog::Kind::keys, draw_keys_dialog},
    DialogRow{Dialog::Kind::about, draw_about_dialog},
    DialogRow{Dialog::Kind::save_picture, draw_still_dialog},
    DialogRow{Dialog::Kind::export_frames, draw_export_dialog},
    DialogRow{Dialog::Kind::export_look, draw_look_export_dialog},
    DialogRow{Dialog::Kind::live_source, draw_live_dialog},
    DialogRow{Dialog::Kind::send_look, draw_send_dialog},
    DialogRow{Dialog::Kind::quit_exporting, draw_quit_exporting_dialog},
    DialogRow{Dialog::Kind::asked, draw_asked_dialog},
};
}  // namespace

void draw_dialogs(const Scene& scene, Edits& edits) {
    const Dialog::Kind kind = scene.window.dialog.kind;
    if (file_dialog_kind(kind))
        return draw_file_dialog(scene, edits);
    const auto row = std::ranges::find(dialog_rows, kind, &DialogRow::kind);
    if (row != dialog_rows.end())
        row->draw(scene, edits);
}
