#pragma once

#include <filesystem>

/// The program's folder where the variable (XDG_DATA_HOME, ...) says, else below the user's home.
std::filesystem::path folder_from_environment(const char* name, const char* below_home);

/// Where sockets are made without being asked for, for programs of this user alone:
/// $XDG_RUNTIME_DIR/afterglow, without the variable "run" in the program's folder of states.
std::filesystem::path runtime_folder();
