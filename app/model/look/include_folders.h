#pragma once

#include <filesystem>
#include <utility>
#include <vector>

/// Folders outside a look that its shaders may include files from.
struct IncludeFolders {
    std::filesystem::path shared;              // the program's shaders/include; "": not available
    std::vector<std::filesystem::path> named;  // from --include or the settings; searched last

    // Implicit: most callers only have the program's folder.
    IncludeFolders(std::filesystem::path shared_folder = {},
                   std::vector<std::filesystem::path> named_folders = {})
        : shared(std::move(shared_folder)), named(std::move(named_folders)) {}

    bool operator==(const IncludeFolders&) const = default;
};
