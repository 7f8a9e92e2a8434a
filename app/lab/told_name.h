#pragma once

#include <filesystem>
#include <string>

/// A file as it is told in a few words: its name, with the folder where many files have that name
/// ("crt/look.json").
std::string told_name(const std::filesystem::path& file);
