#include "lab/window/look_list.h"

#include "lab/storage/display_name.h"
#include "lab/window/search_words.h"

#include <algorithm>

std::vector<const ListedLook*> matching_looks(const std::vector<ListedLook>& looks,
                                              std::string_view search) {
    std::vector<const ListedLook*> found;
    for (const ListedLook& look : looks)
        if (has_search_words(look.name + ' ' + look.entry.id + ' ' + look.about, search))
            found.push_back(&look);
    return found;
}

std::vector<RecentLook> recent_looks(const std::vector<std::string>& recent,
                                     const std::vector<ListedLook>& looks,
                                     const std::string& open) {
    constexpr std::size_t maximum = 10;
    std::vector<RecentLook> found;
    for (const std::string& argument : recent) {
        if (argument == open || found.size() == maximum)
            continue;
        const auto listed = std::ranges::find(looks, argument, &ListedLook::argument);
        found.push_back({argument, listed != looks.end() ? listed->name : display_name(argument)});
    }
    return found;
}

std::filesystem::path picture_folder(const ListedLook& look, const Roots& roots) {
    if (look.is_stack())
        return roots.program / "presets" / look.entry.id;
    return look.entry.foreign_folder.empty() ? look.entry.folder : look.entry.foreign_folder;
}
