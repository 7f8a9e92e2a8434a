#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// The number of this process.
int process_id();

/// The path of this program's file; "" if unknown.
std::filesystem::path program_file();

/// The command that starts this program again, even if its file has been replaced since the start.
std::string program_command();

/// Whether a program of this name can be started from $PATH.
bool is_in_path(const std::string& program);

/// Starts a program from $PATH and does not wait for it. Returns errno; 0: success. `ended` is
/// called on another thread with the exit status, or 128 + the signal that ended it.
int start_detached(const std::vector<std::string>& command, std::function<void(int)> ended = {});

/// Ends this process like an invalid memory access.
void crash_process();
