#include "lab/files/folder_listing.h"

#include "base/file.h"
#include "base/text.h"
#include "io/system/file_status.h"

#include <algorithm>
#include <chrono>

namespace fs = std::filesystem;

namespace {
// Files with a wanted ending that Afterglow cannot open: CMakeLists.txt, and .json files that are
// neither looks, presets nor Shadertoy shaders.
bool is_of_others(const fs::path& file, const std::string& ending) {
    if (ending != ".json")
        return file.filename() == "CMakeLists.txt";
    constexpr std::size_t beginning = 4096;  // bytes that contain the format
    const auto text = read_start(file, beginning);
    if (!text || text->empty())
        return false;
    const bool is_shader = text->find("\"renderpass\"") != std::string::npos ||
                           text->find("\"Shader\"") != std::string::npos;
    return text->find("\"afterglow-") == std::string::npos && !is_shader &&
           file.filename() != "look.json";
}

std::int64_t seconds_of(fs::file_time_type time) {
    const auto since = std::chrono::file_clock::to_sys(time).time_since_epoch();
    return std::chrono::duration_cast<std::chrono::seconds>(since).count();
}

FolderEntry entry_of(const fs::directory_entry& found) {
    std::error_code error;  // unreadable entries are listed as files of unknown size
    FolderEntry entry{found.path().filename().string(), found.is_directory(error)};
    if (!entry.is_folder && found.is_regular_file(error)) {
        const std::uintmax_t bytes = found.file_size(error);
        entry.bytes = error ? 0 : bytes;
    }
    const fs::file_time_type time = found.last_write_time(error);
    entry.modified = error ? 0 : seconds_of(time);
    return entry;
}

std::string problem_text(const std::error_code& error) {
    if (error == std::errc::no_such_file_or_directory)
        return "This folder doesn't exist.";
    if (error == std::errc::permission_denied)
        return "You don't have permission to read this folder.";
    if (error == std::errc::not_a_directory)
        return "This isn't a folder.";
    return "Can't read this folder: " + error.message();
}
}  // namespace

bool is_folder(const fs::path& path) {
    std::error_code error;
    return !path.empty() && fs::is_directory(path, error);
}

FolderListing list_folder(const fs::path& folder, const std::vector<std::string>& extensions,
                          JobProgress* work) {
    FolderListing listing{.folder = folder, .entries = {}, .problem = {}};
    std::error_code error;
    for (fs::directory_iterator found(folder, error), end; !error && found != end;
         found.increment(error)) {
        if (work && work->is_cancelled)
            return listing;
        std::error_code ignored;
        const std::string ending = to_lower(found->path().extension().string());
        const bool is_wanted =
            extensions.empty() || found->is_directory(ignored) ||
            (std::ranges::count(extensions, ending) > 0 && !is_of_others(found->path(), ending));
        if (is_wanted)
            listing.entries.push_back(entry_of(*found));
    }
    if (error)
        listing.problem = problem_text(error);
    listing.is_writable = is_writable(folder);
    return listing;
}
