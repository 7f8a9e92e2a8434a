#include "formats/slang/similar_file.h"

#include "base/text.h"

#include <fmt/format.h>

#include <optional>

namespace fs = std::filesystem;

namespace {
// The entry of a folder with this name, ignoring case.
std::optional<fs::path> entry_called(const fs::path& folder, const fs::path& name) {
    constexpr int max_entries = 10000;
    const std::string wanted = to_lower(name.string());
    std::error_code error;
    int entries = 0;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error);
         entry != fs::directory_iterator() && ++entries < max_entries; entry.increment(error)) {
        if (error)
            break;
        if (to_lower(entry->path().filename().string()) == wanted)
            return folder / entry->path().filename();
    }
    return std::nullopt;
}

std::optional<fs::path> in_other_letters(const fs::path& file) {
    fs::path found;
    std::error_code error;
    for (const fs::path& part : file) {
        if (fs::exists(found / part, error) || part == "..") {
            found /= part;
            continue;
        }
        const auto entry = entry_called(found, part);
        if (!entry)
            return std::nullopt;
        found = *entry;
    }
    return found;
}
}  // namespace

std::string similar_file(const fs::path& wanted, const fs::path& from) {
    const fs::path folder = from.parent_path();
    for (const fs::path& candidate : {wanted, folder / wanted.filename()}) {
        const auto found = in_other_letters(candidate);
        std::error_code error;
        if (!found || !fs::is_regular_file(*found, error))
            continue;
        const fs::path shown = folder.empty() ? *found : found->lexically_relative(folder);
        return fmt::format(" (did you mean '{}'?)", shown.string());
    }
    return {};
}
