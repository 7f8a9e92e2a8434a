#include "lab/choices/preset_choices.h"

#include "lab/lab.h"

#include <fmt/format.h>

namespace {
ChoiceList morph_choices(const std::vector<ListedPreset>& presets, double seconds) {
    ChoiceList list{"Morph", ChoiceList::Place::file};
    for (const ListedPreset& preset : presets)
        list.choices.push_back({.name = fmt::format("To {}", preset.preset.name),
                                .commands = {[file = preset.preset.entry.file, seconds](Lab& lab) {
                                    lab.presets().navigation().morph_to(file, seconds);
                                }}});
    for (const double length : morph_lengths)
        list.choices.push_back(
            {.name = fmt::format("Duration {:g} s", length),
             .commands = {[length](WindowState& window) { window.presets.morph_seconds = length; }},
             .is_present = length == seconds});
    return list;
}

ChoiceList star_choices(const std::vector<ListedPreset>& presets) {
    ChoiceList list{"Star"};
    for (const ListedPreset& preset : presets)
        if (!preset.is_plain())
            list.choices.push_back(
                {.name = preset.preset.name,
                 .commands = {[name = preset.preset.entry.id, has_star = !preset.has_star](
                                  Lab& lab) { lab.presets().navigation().star(name, has_star); }},
                 .is_present = preset.has_star});
    return list;
}

void show_preset_pictures(WindowState& window) {
    window.shows_bottom = true;
    window.bottom_part = BottomPart::presets;
    window.is_picture_only = false;
}

ChoiceList browsing_choices(const PresetBrowsing& wanted) {
    ChoiceList list{"Presets"};
    list.choices.push_back({.name = "Favourites only",
                            .commands = {[](WindowState& window) {
                                window.presets.only_starred = !window.presets.only_starred;
                                show_preset_pictures(window);
                            }},
                            .is_present = wanted.only_starred});
    list.choices.push_back(
        {.name = "Search…",
         .text = AskedText{wanted.search, [](const std::string& words) -> MenuCommands {
                               return {[words](WindowState& window) {
                                   window.presets.search = words;
                                   show_preset_pictures(window);
                               }};
                           }}});
    return list;
}
}  // namespace

std::vector<ChoiceList> preset_choices(const std::vector<ListedPreset>& presets,
                                       const PresetBrowsing& wanted) {
    return {morph_choices(presets, wanted.morph_seconds), star_choices(presets),
            browsing_choices(wanted)};
}

ChoiceList shipped_preset_choices() {
    return {"Preset",
            ChoiceList::Place::palette,
            {{.name = "Save to shipped presets",
              .commands = {[](Lab& lab) { lab.presets().save_into_shipped(); }}}}};
}
