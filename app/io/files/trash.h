#pragma once

#include "base/diagnostic.h"

#include <filesystem>

/// A file in the desktop's trash, and its original path.
struct TrashedFile {
    std::filesystem::path original;
    std::filesystem::path file;  // its path in the trash
    std::filesystem::path info;  // has the original path and the deletion date
};

/// Moves a file to the trash: $XDG_DATA_HOME/Trash, or .Trash-UID at the top of the
/// file's volume. Follows the Trash specification 1.0 of freedesktop.org. On an error the file is
/// unchanged.
Result<TrashedFile> move_to_trash(const std::filesystem::path& file);

/// Moves it back. Fails if another file now has its original path.
Result<void> restore_from_trash(const TrashedFile& trashed);
