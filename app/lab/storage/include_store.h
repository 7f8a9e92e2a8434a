#pragma once

#include "lab/storage/roots.h"

/// The folders that the user named in the window for includes, one a line of the file; none where
/// there is no file.
std::vector<std::filesystem::path> load_include_folders(const Roots& roots);
Result<void> save_include_folders(const Roots& roots,
                                  const std::vector<std::filesystem::path>& folders);

/// Folders as the user types them, with ':' between; "~/" is the user's home folder.
std::vector<std::filesystem::path> parse_include_folders(std::string_view text);
std::string include_folders_text(const std::vector<std::filesystem::path>& folders);
