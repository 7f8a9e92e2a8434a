#pragma once

#include <filesystem>

/// The program's folder in the variable's folder (XDG_DATA_HOME, ...), or below the user's home.
std::filesystem::path folder_from_environment(const char* name, const char* below_home);

/// The folder for sockets with default names, private to this user: $XDG_RUNTIME_DIR/afterglow.
/// Without the variable, "run" in the program's state folder.
std::filesystem::path runtime_folder();
