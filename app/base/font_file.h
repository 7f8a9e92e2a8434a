#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>

/// Sets the folder of the fonts that the program carries; searched after those of the system.
void set_own_fonts(const std::filesystem::path& folder);

/// The path of the first of these fonts ("DejaVuSans.ttf") found in the system's font folders or
/// the program's own; "" if not found.
std::string find_font_file(std::initializer_list<const char*> names);
