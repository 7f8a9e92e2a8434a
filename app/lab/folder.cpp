#include "lab/folder.h"

#include "base/text.h"

#include <algorithm>
#include <tuple>

namespace fs = std::filesystem;

std::vector<FolderEntry> list_folder(const fs::path& folder,
                                     const std::vector<std::string>& endings) {
    std::vector<FolderEntry> entries;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with('.'))
            continue;
        std::error_code ignored;  // what cannot be looked at is listed as a file
        const bool is_folder = entry->is_directory(ignored);
        const std::string ending = to_lower(entry->path().extension().string());
        if (is_folder || endings.empty() ||
            std::find(endings.begin(), endings.end(), ending) != endings.end())
            entries.push_back({name, is_folder});
    }
    std::sort(entries.begin(), entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
        return std::tuple(!a.is_folder, to_lower(a.name), a.name) <
               std::tuple(!b.is_folder, to_lower(b.name), b.name);
    });
    return entries;
}
