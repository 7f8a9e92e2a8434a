#pragma once

#include "formats/json/object_reader.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

/// The folder of a look. All files named by its manifest must be in it. A link counts by its own
/// path.
class LookFolder {
public:
    /// `files` receives every requested path, also missing ones.
    LookFolder(std::filesystem::path folder, std::vector<std::filesystem::path>& files)
        : m_folder(std::move(folder)), m_files(files) {}

    /// The file for `name`, given in `value`. nullopt, with an error at the value's line, if it is
    /// missing, not a file, or outside the folder (absolute, "..").
    std::optional<std::filesystem::path> find(std::string_view name, const JsonValue& value,
                                              ObjectReader& reader);

private:
    std::string nearest_name(const std::filesystem::path& file) const;

    std::filesystem::path m_folder;
    std::vector<std::filesystem::path>& m_files;
};
