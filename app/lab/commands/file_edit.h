#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The content of a file before and after an edit, in bytes. nullopt: the file does not exist.
struct FileChange {
    std::filesystem::path file;
    std::optional<std::string> before;
    std::optional<std::string> after;
};

/// Changes of several files that belong together, in the order of writing.
using FileEdit = std::vector<FileChange>;

/// The edit that reverts another one.
FileEdit reversed(const FileEdit& edit);

/// Writes all files of an edit, or none. Removed files go to the desktop's trash. Fails without any
/// change if a file differs from `before`: another program has changed it since.
Result<void> apply(const FileEdit& edit);
