#include "ui/library_panel.h"

#include "ui/compare_dialog.h"
#include "ui/scoped.h"
#include "ui/stack_panel.h"
#include "ui/theme.h"
#include "ui/widgets.h"

#include <fmt/format.h>

namespace {
struct Line {
    std::string label;
    std::string about;
    bool is_open = false;
    bool is_modified = false;
};

// A line of the list; true when it was clicked.
bool draw_line(const Line& line) {
    const ScopedId id(line.label);
    const ImVec2 at = ImGui::GetCursorPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const bool is_clicked = ImGui::Selectable("##line", line.is_open);
    tooltip(line.about);
    const float mark = line.is_modified ? ImGui::CalcTextSize(" •").x : 0.0f;
    const std::string text = cut_to_fit(line.label, width - mark - 4.0f);
    ImGui::SetCursorPos({at.x + 4.0f, at.y});
    const ScopedColor color(ImGuiCol_Text, line.is_open ? theme::accent : theme::text);
    ImGui::TextUnformatted((text + (line.is_modified ? " •" : "")).c_str());
    return is_clicked;
}

bool is_open_preset(const Document& document, const ShelfPreset& preset) {
    std::error_code error;
    return document.preset_file() == preset.entry.file ||
           (!document.preset_file().empty() &&
            std::filesystem::equivalent(document.preset_file(), preset.entry.file, error));
}

void draw_preset_menu(bool is_open, const ShelfPreset& preset, const Scene& scene, Edits& edits) {
    const std::string file = preset.entry.file.string();
    if (!ImGui::BeginPopupContextItem("##preset_menu"))
        return;
    if (ImGui::MenuItem("Open"))
        edits.open(scene.lab, file);
    if (ImGui::MenuItem("Compare with what is open"))
        compare_preset(preset, scene, edits);
    edits.mark("compare:" + preset.entry.name);
    if (ImGui::BeginMenu("Morph to it in")) {
        for (const int seconds : {1, 3, 10, 30, 60}) {
            if (ImGui::MenuItem(fmt::format("{} s", seconds).c_str()))
                edits.add([file, seconds](Lab& lab) { lab.morph_to(file, seconds); });
            edits.mark(fmt::format("morph:{}", seconds));
        }
        ImGui::EndMenu();
    }
    edits.mark("morph_to:" + preset.entry.name);
    if (is_open) {
        if (ImGui::MenuItem("Rename…"))
            edits.show(
                {.kind = Dialog::Kind::rename_preset, .text = scene.lab.document()->preset_name()});
        if (ImGui::MenuItem("Duplicate"))
            edits.add([](Lab& lab) { lab.duplicate_preset(); });
        if (ImGui::MenuItem("Delete…"))
            edits.show({.kind = Dialog::Kind::delete_preset});
    }
    ImGui::EndPopup();
}

void draw_presets(const ShelfLook& look, const Scene& scene, Edits& edits) {
    const Document& document = *scene.lab.document();
    const float indent = ImGui::GetStyle().IndentSpacing;
    ImGui::Indent(indent);
    const bool has_none = document.preset_file().empty();
    if (draw_line({.label = "As the look has it",
                   .about = "Every parameter at its default.",
                   .is_open = has_none,
                   .is_modified = has_none && document.is_modified()}))
        edits.open(scene.lab, look.argument());
    edits.mark("preset:");
    for (const ShelfPreset& preset : look.presets) {
        const bool is_open = is_open_preset(document, preset);
        const std::string file = preset.entry.file.string();
        const ScopedId id(file);
        ImGui::BeginGroup();
        const bool is_clicked = draw_line({.label = preset.name,
                                           .about = preset.about,
                                           .is_open = is_open,
                                           .is_modified = is_open && document.is_modified()});
        ImGui::EndGroup();
        edits.mark("preset:" + preset.entry.name);
        draw_preset_menu(is_open, preset, scene, edits);
        if (is_clicked)
            edits.open(scene.lab, file);
    }
    ImGui::Unindent(indent);
}

bool is_open_look(const Document& document, const ShelfLook& look) {
    if (look.is_stack() || document.look().stack.size() > 1)
        return document.look().id == look.entry.id;
    return document.look().manifest.parent_path() == look.entry.folder;
}

void draw_look_menu(const ShelfLook& look, const Scene& scene, Edits& edits) {
    if (!ImGui::BeginPopupContextItem("##look_menu"))
        return;
    if (ImGui::MenuItem("Open"))
        edits.open(scene.lab, look.argument());
    if (!look.is_stack() && scene.lab.document() && ImGui::MenuItem("Add behind the open look"))
        add_to_stack(look, edits);
    ImGui::EndPopup();
}
}  // namespace

void draw_library_panel(const Scene& scene, Edits& edits) {
    const Document* document = scene.lab.document();
    heading("Looks");
    for (const ShelfLook& look : scene.shelf.looks()) {
        const ScopedId id(look.argument());
        const bool is_open = document && is_open_look(*document, look);
        bool is_clicked = false;
        {
            const ScopedFont font(is_open ? scene.fonts.strong : scene.fonts.text);
            ImGui::BeginGroup();
            is_clicked = draw_line({.label = look.name, .about = look.about});
            ImGui::EndGroup();
            edits.mark("look:" + look.entry.id);
        }
        draw_look_menu(look, scene, edits);
        if (is_clicked && !is_open)
            edits.open(scene.lab, look.argument());
        if (is_open)
            draw_presets(look, scene, edits);
    }
    if (scene.shelf.looks().empty())
        dim_text("There is none yet.");
}
