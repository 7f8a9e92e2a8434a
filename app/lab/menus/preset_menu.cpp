#include "lab/menus/preset_menu.h"

#include "lab/commands/preset_commands.h"
#include "lab/window/window_state.h"

#include <fmt/format.h>

namespace {
MenuSection morph_section(const std::vector<ListedPreset>& presets, double seconds) {
    MenuSection section{"Morph", MenuSection::Menu::file};
    for (const ListedPreset& preset : presets)
        section.entries.push_back({.name = fmt::format("To {}", preset.preset.name),
                                   .commands = {[file = preset.preset.entry.file, seconds](
                                                    PresetCommands& commands, Messages& messages) {
                                       messages.succeeded(
                                           commands.navigation().morph_to(file, seconds));
                                   }}});
    for (const double length : morph_lengths)
        section.entries.push_back(
            {.name = fmt::format("Duration {:g} s", length),
             .commands = {[length](WindowState& window) { window.presets.morph_seconds = length; }},
             .is_present = length == seconds});
    return section;
}

MenuSection star_section(const std::vector<ListedPreset>& presets) {
    MenuSection section{"Star"};
    for (const ListedPreset& preset : presets)
        if (!preset.is_plain())
            section.entries.push_back(
                {.name = preset.preset.name,
                 .commands = {[name = preset.preset.entry.id,
                               has_star = !preset.has_star](PresetCommands& commands) {
                     commands.navigation().star(name, has_star);
                 }},
                 .is_present = preset.has_star});
    return section;
}

void show_preset_pictures(WindowState& window) {
    window.layout.reveal(panel_id::presets);
}

MenuSection browsing_section(const PresetBrowsing& wanted) {
    MenuSection section{"Presets"};
    section.entries.push_back({.name = "Favourites only",
                               .commands = {[](WindowState& window) {
                                   window.presets.only_starred = !window.presets.only_starred;
                                   show_preset_pictures(window);
                               }},
                               .is_present = wanted.only_starred});
    section.entries.push_back(
        {.name = "Search…",
         .text = TextPrompt{wanted.search, [](const std::string& search) -> std::vector<Edit> {
                                return {[search](WindowState& window) {
                                    window.presets.search = search;
                                    show_preset_pictures(window);
                                }};
                            }}});
    return section;
}
}  // namespace

std::vector<MenuSection> preset_sections(const std::vector<ListedPreset>& presets,
                                         const PresetBrowsing& wanted) {
    return {morph_section(presets, wanted.morph_seconds), star_section(presets),
            browsing_section(wanted)};
}

MenuSection shipped_preset_section() {
    return {"Preset",
            MenuSection::Menu::palette,
            {{.name = "Save to shipped presets",
              .commands = {[](PresetCommands& commands) { commands.save_into_shipped(); }}}}};
}
