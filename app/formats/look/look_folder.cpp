#include "formats/look/look_folder.h"

#include "base/text.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace {
bool climbs(const fs::path& path) {
    return std::find(path.begin(), path.end(), "..") != path.end();
}
}  // namespace

std::optional<fs::path> LookFolder::find(std::string_view name, const JsonValue& value,
                                         ObjectReader& reader) {
    const auto refuse = [&](std::string message) {
        reader.problem(value, std::move(message));
        return std::nullopt;
    };
    const fs::path relative(name);
    if (name.empty() || name.find('\0') != std::string_view::npos)
        return refuse(fmt::format("'{}' isn't a valid file name", name));
    if (relative.is_absolute() || climbs(relative))
        return refuse(fmt::format(
            "'{}' is outside the look's folder. Copy the file into the look's folder.", name));
    const fs::path file = m_folder / relative;
    if (std::find(m_files.begin(), m_files.end(), file) == m_files.end())
        m_files.push_back(file);
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status))
        return refuse(
            fmt::format("can't find '{}' in the look's folder{}", name, nearest_name(file)));
    if (!fs::is_regular_file(status))
        return refuse(fmt::format("'{}' isn't a file", name));
    return file;
}

std::string LookFolder::nearest_name(const fs::path& file) const {
    constexpr std::size_t max_names = 1000;
    std::vector<std::string> names;
    std::error_code error;
    for (fs::directory_iterator entry(file.parent_path().empty() ? "." : file.parent_path(), error);
         entry != fs::directory_iterator() && names.size() < max_names; entry.increment(error))
        names.push_back(entry->path().filename().string());
    std::sort(names.begin(), names.end());
    return did_you_mean(file.filename().string(), names);
}
