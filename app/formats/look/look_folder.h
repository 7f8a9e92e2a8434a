#pragma once

#include "formats/json/object_reader.h"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

/// The folder of a look: everything that its manifest names lies in it. A link counts where it
/// stands.
class LookFolder {
public:
    /// `files` gets every path that is asked for, also those that are missing.
    LookFolder(std::filesystem::path folder, std::vector<std::filesystem::path>& files)
        : m_folder(std::move(folder)), m_files(files) {}

    /// The file that `name`, written in `value`, stands for. Nothing, and noted at the value's
    /// line, where it is missing, no file, or leads out of the folder (absolute, "..").
    std::optional<std::filesystem::path> find(std::string_view name, const JsonValue& value,
                                              ObjectReader& reader);

private:
    std::string nearest_name(const std::filesystem::path& file) const;

    std::filesystem::path m_folder;
    std::vector<std::filesystem::path>& m_files;
};
