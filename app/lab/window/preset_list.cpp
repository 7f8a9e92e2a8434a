#include "lab/window/preset_list.h"

#include "base/text.h"
#include "lab/document/opened_preset.h"

#include <algorithm>

namespace {
bool matches(const ListedLookPreset& preset, const std::string& search) {
    const std::string text = to_lower(preset.name + ' ' + preset.entry.name + ' ' + preset.about);
    const std::string lower = to_lower(search);
    return std::ranges::all_of(split(lower, ' '), [&](std::string_view word) {
        return text.find(word) != std::string::npos;
    });
}
}  // namespace

bool is_open_preset(const Document& document, const std::filesystem::path& file) {
    const std::filesystem::path& open = preset_file(document);
    std::error_code error;
    return open == file ||
           (!open.empty() && !file.empty() && std::filesystem::equivalent(open, file, error));
}

ListedPreset as_listed(const ListedLookPreset& preset, const Document& document,
                       const FavouritePresets& stars) {
    const bool is_open = is_open_preset(document, preset.entry.file);
    return {.preset = preset,
            .is_open = is_open,
            .is_modified = is_open && is_modified(document),
            .has_star = stars.contains(favourite_key(document.look().id, preset.entry.id))};
}

std::vector<ListedPreset> listed_presets(const Document& document,
                                         const std::vector<ListedLook>& looks,
                                         const FavouritePresets& stars,
                                         const PresetBrowsing& wanted) {
    std::vector<ListedPreset> listed;
    const auto add = [&](const ListedLookPreset& preset) {
        ListedPreset entry = as_listed(preset, document, stars);
        if ((entry.has_star || !wanted.only_starred) && matches(preset, wanted.search))
            listed.push_back(std::move(entry));
    };
    add({{document.look().id, {}, {}}, "Default", "All parameters at their defaults."});
    const auto look = std::ranges::find_if(
        looks, [&](const ListedLook& known) { return known.entry.id == document.look().id; });
    if (look != looks.end())
        for (const ListedLookPreset& preset : look->presets)
            add(preset);
    return listed;
}
