#pragma once

#include <initializer_list>
#include <string>

/// The first of these fonts ("DejaVuSans.ttf") that lies in one of the folders where systems keep
/// fonts, with its path; "" where none does.
std::string find_font_file(std::initializer_list<const char*> names);
