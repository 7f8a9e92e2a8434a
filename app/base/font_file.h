#pragma once

#include <initializer_list>
#include <string>

/// The path of the first of these fonts ("DejaVuSans.ttf") found in the system's font folders; ""
/// if not found.
std::string find_font_file(std::initializer_list<const char*> names);
