#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// One line of a folder's listing.
struct FolderEntry {
    std::string name;
    bool is_folder = false;

    bool operator==(const FolderEntry&) const = default;
};

/// What a folder holds: folders first, then files, each by name; hidden ones are left out. Only
/// files with one of the `endings` (".wav", lower case); none: all. Empty where it cannot be read.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder,
                                     const std::vector<std::string>& endings);
