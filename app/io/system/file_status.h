#pragma once

#include "base/file_stamp.h"

#include <filesystem>
#include <optional>

/// Whether this user may write to a file or folder that exists.
bool is_writable(const std::filesystem::path& path);

/// The stamp of a file, or of the target of a link; nullopt if it is missing.
std::optional<FileStamp> read_file_stamp(const std::filesystem::path& file);
