#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// An entry of a folder.
struct FolderEntry {
    std::string name;
    bool is_folder = false;

    bool operator==(const FolderEntry&) const = default;
};

/// The entries of a folder: folders first, then files, sorted by name, without hidden ones. Only
/// files with one of the `extensions` (".wav", lower case); empty: all. An unreadable folder gives
/// an empty list.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder,
                                     const std::vector<std::string>& extensions);
