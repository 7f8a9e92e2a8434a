#include "ui/library/preset_menu.h"

#include "lab/commands/preset_commands.h"
#include "lab/document/content_edits.h"
#include "ui/dialogs/compare_dialog.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

namespace {
void draw_morph_items(const ListedPreset& preset, const Scene& scene, Edits& edits) {
    if (ImGui::BeginMenu("Morph in")) {
        for (const int seconds : {1, 3, 10, 30, 60}) {
            const bool is_present = scene.window.presets.morph_seconds == seconds;
            if (ImGui::MenuItem(fmt::format("{} s", seconds).c_str(), nullptr, is_present)) {
                edits.arrange(
                    [seconds](WindowState& window) { window.presets.morph_seconds = seconds; });
                edits.change([file = preset.preset.entry.file, seconds](PresetCommands& presets,
                                                                        Messages& messages) {
                    messages.succeeded(presets.navigation().morph_to(file, seconds));
                });
            }
            edits.mark(fmt::format("morph:{}", seconds));
        }
        ImGui::EndMenu();
    }
    edits.mark("morph_to:" + preset.preset.entry.id);
}

void draw_file_items(const ListedLookPreset& preset, Edits& edits) {
    const std::filesystem::path& file = preset.entry.file;
    ImGui::Separator();
    if (!preset.entry.is_shipped) {
        if (ImGui::MenuItem("Rename…"))
            edits.show({.kind = Dialog::Kind::rename_preset,
                        .text = preset.name,
                        .subject = file.string()});
        edits.mark("rename:" + preset.entry.id);
    }
    if (ImGui::MenuItem("Duplicate"))
        edits.change([file](PresetCommands& presets) { presets.duplicate(file); });
    edits.mark("duplicate:" + preset.entry.id);
    if (!preset.entry.is_shipped) {
        if (ImGui::MenuItem("Delete"))
            edits.change([file](PresetCommands& presets) { presets.remove(file); });
        edits.mark("delete:" + preset.entry.id);
    }
    if (ImGui::MenuItem("Show in folder"))
        edits.change([file](PresetCommands& presets) { presets.show_in_folder(file); });
    edits.mark("show_in_folder:" + preset.entry.id);
}
}  // namespace

void open_listed(const ListedPreset& preset, const Scene& scene, Edits& edits,
                 bool brings_content) {
    const std::string argument = preset.is_plain() ? argument_of(scene.lab.document->look())
                                                   : preset.preset.entry.file.string();
    if (brings_content)
        edits.open_with_content(argument);
    else
        edits.open(argument);
}

void morph_to_listed(const ListedPreset& preset, const Scene& scene, Edits& edits) {
    edits.change([file = preset.preset.entry.file, seconds = scene.window.presets.morph_seconds](
                     PresetCommands& presets, Messages& messages) {
        messages.succeeded(presets.navigation().morph_to(file, seconds));
    });
}

void star_listed(const ListedPreset& preset, Edits& edits) {
    edits.change([name = preset.preset.entry.id, has_star = !preset.has_star](
                     PresetCommands& presets) { presets.navigation().star(name, has_star); });
}

void draw_preset_menu(const ListedPreset& preset, const Scene& scene, Edits& edits) {
    if (!ImGui::BeginPopupContextItem("##preset_menu"))
        return;
    if (ImGui::MenuItem("Open"))
        open_listed(preset, scene, edits);
    if (is_content_locked(*scene.lab.document)) {
        const Look& look = scene.lab.document->look();
        const char* label = look.has_other_driver               ? "Open with its signal or source"
                            : look.driven_by == Driver::picture ? "Open with its source"
                                                                : "Open with its signal";
        if (ImGui::MenuItem(label, "Alt+click"))
            open_listed(preset, scene, edits, true);
        edits.mark("open_own:" + preset.preset.entry.id);
    }
    if (!preset.is_plain()) {
        if (ImGui::MenuItem("Compare with current settings"))
            compare_preset(preset.preset, scene, edits);
        edits.mark("compare:" + preset.preset.entry.id);
    }
    draw_morph_items(preset, scene, edits);
    if (!preset.is_plain()) {
        if (ImGui::MenuItem("Favourite", nullptr, preset.has_star))
            star_listed(preset, edits);
        edits.mark("star_preset:" + preset.preset.entry.id);
        draw_file_items(preset.preset, edits);
    }
    ImGui::EndPopup();
}
