#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// One job of a render farm: the pictures that it draws.
struct FarmPart {
    std::int64_t first = 0;              // number of its first picture
    std::int64_t end = 0;                // after its last picture
    std::vector<std::string> arguments;  // of `FarmWork::command`, for this part

    bool operator==(const FarmPart&) const = default;
};

/// A film or sweep that is drawn in parts. A part is the command with the part's arguments; it
/// writes the files "frames/%04d.png" of the folder of scripts.
struct FarmWork {
    std::string name;                 // in the lists of a farm: letters, digits, '-', '_' and '.'
    std::filesystem::path directory;  // absolute: where the commands start
    std::vector<std::string> command;
    std::vector<FarmPart> parts;
    std::vector<std::string> join = {};  // makes one file of all pictures; empty: none
};

/// The numbers of pictures `first` to `end` - 1, in parts of `per_part`. The last part can be
/// shorter.
std::vector<FarmPart> split(std::int64_t first, std::int64_t end, std::int64_t per_part);

/// The text as one word of a POSIX shell.
std::string shell_quoted(std::string_view text);
