#pragma once

#include <filesystem>
#include <string>

/// A short name for a file: its file name, with the folder if many files have that name
/// ("crt/look.json").
std::string display_name(const std::filesystem::path& file);

/// Saved "amber.json".
std::string saved_text(const std::string& name);

/// A folder with "~" for the user's home folder.
std::string display_folder(const std::filesystem::path& folder);
