#pragma once

#include <filesystem>
#include <string>

/// A file as it is told in a few words: its name, with the folder where many files have that name
/// ("crt/look.json").
std::string told_name(const std::filesystem::path& file);

/// Saved "amber.json".
std::string saved_words(const std::string& name);

/// A folder with "~" for the user's home.
std::string told_folder(const std::filesystem::path& folder);
