#pragma once

#include <string>
#include <string_view>

/// The name of a golden picture without ".png", valid on every file system: lower case, at most 100
/// bytes each for look and preset, with '-' for a run of other characters than letters, digits and
/// "_.+". "phosphor--amber-p3"; with `preset` "": "phosphor".
std::string golden_name(std::string_view look, std::string_view preset);

/// Whether a text can be such a name. Then it is a file name without a folder.
bool is_golden_name(std::string_view text);
