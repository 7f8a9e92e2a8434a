#include "lab/storage/folder.h"

#include "base/text.h"

#include <algorithm>
#include <fstream>
#include <tuple>

namespace fs = std::filesystem;

namespace {
// Files with a wanted ending that Afterglow cannot open: CMakeLists.txt, and .json files that are
// neither looks, presets nor Shadertoy shaders.
bool is_of_others(const fs::path& file, const std::string& ending) {
    if (ending != ".json")
        return file.filename() == "CMakeLists.txt";
    constexpr std::size_t beginning = 4096;  // bytes that contain the format
    std::string text(beginning, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(text.data(), static_cast<std::streamsize>(beginning));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    const bool is_shader = text.find("\"renderpass\"") != std::string::npos ||
                           text.find("\"Shader\"") != std::string::npos;
    return stream.gcount() > 0 && text.find("\"afterglow-") == std::string::npos && !is_shader &&
           file.filename() != "look.json";
}
}  // namespace

std::vector<FolderEntry> list_folder(const fs::path& folder,
                                     const std::vector<std::string>& extensions) {
    std::vector<FolderEntry> entries;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with('.'))
            continue;
        std::error_code ignored;  // unreadable entries are listed as files
        const bool is_folder = entry->is_directory(ignored);
        const std::string ending = to_lower(entry->path().extension().string());
        const bool is_wanted = extensions.empty() || std::ranges::count(extensions, ending) > 0;
        if (is_folder || extensions.empty() || (is_wanted && !is_of_others(entry->path(), ending)))
            entries.push_back({name, is_folder});
    }
    std::sort(entries.begin(), entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
        return std::tuple(!a.is_folder, to_lower(a.name), a.name) <
               std::tuple(!b.is_folder, to_lower(b.name), b.name);
    });
    return entries;
}
