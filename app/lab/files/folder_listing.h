#pragma once

#include "base/job_progress.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// An entry of a folder.
struct FolderEntry {
    std::string name;
    bool is_folder = false;
    std::uintmax_t bytes = 0;   // of a file; 0 if unknown
    std::int64_t modified = 0;  // seconds since 1970 UTC; 0: unknown

    bool is_hidden() const { return name.starts_with('.'); }
    bool operator==(const FolderEntry&) const = default;
};

/// A folder as read from disk.
struct FolderListing {
    std::filesystem::path folder;
    std::vector<FolderEntry> entries;  // in no particular order, with hidden ones
    std::string problem;               // why it can't be read; "": it was read
    bool is_writable = true;
};

/// Whether the path is a folder; false if that can't be found out.
bool is_folder(const std::filesystem::path& path);

/// Reads a folder: its folders, and its files with one of the `extensions` (".wav", lower case);
/// empty: all. Leaves out .json files that are neither looks, presets nor shaders. Stops early when
/// `work` is cancelled.
FolderListing list_folder(const std::filesystem::path& folder,
                          const std::vector<std::string>& extensions, JobProgress* work = nullptr);
