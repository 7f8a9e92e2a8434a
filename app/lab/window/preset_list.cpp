#include "lab/window/preset_list.h"

#include "lab/document/opened_preset.h"
#include "lab/window/search_words.h"

#include <algorithm>

namespace {
bool matches(const ListedLookPreset& preset, const std::string& search) {
    return has_search_words(preset.name + ' ' + preset.entry.name + ' ' + preset.about, search);
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

std::vector<ListedLookPreset> matching_presets(const Look& look,
                                               const std::vector<ListedLook>& looks,
                                               const FavouritePresets& stars,
                                               const PresetBrowsing& wanted) {
    std::vector<ListedLookPreset> found;
    const auto add = [&](const ListedLookPreset& preset) {
        const bool has_star = stars.contains(favourite_key(look.id, preset.entry.id));
        if ((has_star || !wanted.only_starred) && matches(preset, wanted.search))
            found.push_back(preset);
    };
    add({{look.id, {}, {}}, "Default", "All parameters at their defaults."});
    const auto listed = std::ranges::find_if(
        looks, [&](const ListedLook& known) { return known.entry.id == look.id; });
    if (listed != looks.end())
        std::ranges::for_each(listed->presets, add);
    return found;
}

std::vector<ListedPreset> listed_presets(const Document& document,
                                         const std::vector<ListedLook>& looks,
                                         const FavouritePresets& stars,
                                         const PresetBrowsing& wanted) {
    std::vector<ListedPreset> listed;
    for (const ListedLookPreset& preset : matching_presets(document.look(), looks, stars, wanted))
        listed.push_back(as_listed(preset, document, stars));
    return listed;
}
