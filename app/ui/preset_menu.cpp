#include "ui/preset_menu.h"

#include "lab/users_content.h"
#include "ui/compare_dialog.h"

#include <fmt/format.h>
#include <imgui/imgui.h>

namespace {
void draw_morph_items(const ListedPreset& preset, const Scene& scene, Edits& edits) {
    if (ImGui::BeginMenu("Morph to it in")) {
        for (const int seconds : {1, 3, 10, 30, 60}) {
            const bool is_present = scene.window.presets.morph_seconds == seconds;
            if (ImGui::MenuItem(fmt::format("{} s", seconds).c_str(), nullptr, is_present)) {
                edits.arrange(
                    [seconds](WindowState& window) { window.presets.morph_seconds = seconds; });
                edits.add([file = preset.preset.entry.file, seconds](Lab& lab) {
                    lab.morph_to(file, seconds);
                });
            }
            edits.mark(fmt::format("morph:{}", seconds));
        }
        ImGui::EndMenu();
    }
    edits.mark("morph_to:" + preset.preset.entry.name);
}

void draw_open_items(const Scene& scene, Edits& edits) {
    if (ImGui::MenuItem("Rename…"))
        edits.show(
            {.kind = Dialog::Kind::rename_preset, .text = scene.lab.document()->preset_name()});
    if (ImGui::MenuItem("Duplicate"))
        edits.add([](Lab& lab) { lab.duplicate_preset(); });
    if (ImGui::MenuItem("Delete…"))
        edits.show({.kind = Dialog::Kind::delete_preset});
}
}  // namespace

void open_listed(const ListedPreset& preset, const Scene& scene, Edits& edits,
                 bool brings_content) {
    const std::string argument = preset.is_plain() ? argument_of(scene.lab.document()->look())
                                                   : preset.preset.entry.file.string();
    if (brings_content)
        edits.open_with_content(argument);
    else
        edits.open(argument);
}

void star_listed(const ListedPreset& preset, Edits& edits) {
    edits.add([name = preset.preset.entry.name, has_star = !preset.has_star](Lab& lab) {
        lab.star_preset(name, has_star);
    });
}

void draw_preset_menu(const ListedPreset& preset, const Scene& scene, Edits& edits) {
    if (!ImGui::BeginPopupContextItem("##preset_menu"))
        return;
    if (ImGui::MenuItem("Open"))
        open_listed(preset, scene, edits);
    if (scene.lab.document()->is_content_locked()) {
        const std::string with = "Open with its own " + content_word(scene.lab.document()->look());
        if (ImGui::MenuItem(with.c_str(), "Alt+click"))
            open_listed(preset, scene, edits, true);
        edits.mark("open_own:" + preset.preset.entry.name);
    }
    if (!preset.is_plain()) {
        if (ImGui::MenuItem("Compare with what is open"))
            compare_preset(preset.preset, scene, edits);
        edits.mark("compare:" + preset.preset.entry.name);
    }
    draw_morph_items(preset, scene, edits);
    if (!preset.is_plain()) {
        if (ImGui::MenuItem("Favourite", nullptr, preset.has_star))
            star_listed(preset, edits);
        edits.mark("star_preset:" + preset.preset.entry.name);
        if (preset.is_open)
            draw_open_items(scene, edits);
    }
    ImGui::EndPopup();
}
