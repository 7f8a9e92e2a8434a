#pragma once

#include "base/diagnostic.h"

#include <filesystem>

/// A file in the desktop's trash, and where it was.
struct TrashedFile {
    std::filesystem::path original;
    std::filesystem::path file;  // as it lies in the trash
    std::filesystem::path info;  // says where it was and when it was moved
};

/// Moves a file to the trash: $XDG_DATA_HOME/Trash, or .Trash-UID at the top of the file's own
/// volume. As the Trash specification 1.0 of freedesktop.org says. On an error the file stays.
Result<TrashedFile> move_to_trash(const std::filesystem::path& file);

/// Moves it back. Refused where another file has its place by now.
Result<void> restore_from_trash(const TrashedFile& trashed);
