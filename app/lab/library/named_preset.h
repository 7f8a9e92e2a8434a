#pragma once

#include "lab/library/library.h"

#include <filesystem>
#include <string>
#include <string_view>

/// A name for comparing: lower case, with "-" for each run of other ASCII characters than letters
/// and digits. "Amber P3" and "amber_p3" are "amber-p3".
std::string normalized_name(std::string_view name);

/// The file of a preset by its file name, id or displayed name, as a performer would type it:
/// "amber-p3", "Amber P3", "user:glow". "LOOK/NAME" is a preset of another look. The user's presets
/// come first. "" is the look without a preset, named "default". Fails with the most similar name.
Result<std::filesystem::path> find_named_preset(const Library& library, const std::string& look,
                                                const std::string& name);

/// The name that resolve_preset() finds a preset of the look by: its displayed name if that is
/// unambiguous, otherwise its id, or its path if it is not in the library.
std::string reference_to_preset(const Library& library, const std::string& look,
                                const std::filesystem::path& file, const std::string& name);
