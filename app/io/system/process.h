#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// The number of this process.
int process_id();

/// The path of this program's file; "" if unknown.
std::filesystem::path program_file();

/// The command that starts this program again, even if its file has been replaced since the start.
std::string program_command();

/// Starts a program from $PATH and does not wait for it. Returns errno; 0: success.
int start_detached(const std::vector<std::string>& command);

/// Ends this process like an invalid memory access.
void crash_process();
