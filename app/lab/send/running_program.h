#pragma once

#include "base/diagnostic.h"

#include <filesystem>
#include <string>
#include <vector>

/// A program on this machine that loads an exported look while it runs.
struct RunningProgram {
    std::string name;             // "RetroArch"
    std::string target;           // the export target's name: "slang"
    std::string address;          // the usual one: "55355"
    std::string kind_of_address;  // "Port"
    std::string help;             // how the user makes it listen, a sentence
    /// Tells it to load a file. Waits at most a second for the answer. Errors say what to do.
    Result<void> (*load)(const std::filesystem::path& file, const std::string& address);
};

/// RetroArch and mpv.
const std::vector<RunningProgram>& running_programs();
/// The index in running_programs() of the program that loads a target's files; nullopt: none.
std::optional<std::size_t> program_for(const std::string& target);
