#pragma once

#include "lab/storage/roots.h"

/// The include folders that the user set in the window, one per line of the file. Empty if the file
/// does not exist.
std::vector<std::filesystem::path> load_include_folders(const Roots& roots);
Result<void> save_include_folders(const Roots& roots,
                                  const std::vector<std::filesystem::path>& folders);

/// Parses folders separated by ':'; "~/" is the user's home folder.
std::vector<std::filesystem::path> parse_include_folders(std::string_view text);
std::string include_folders_text(const std::vector<std::filesystem::path>& folders);
